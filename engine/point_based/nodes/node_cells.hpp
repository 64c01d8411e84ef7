#pragma once

#include <vector>

#include "engine/point_based/nodes/body_lattice.hpp"

namespace pliant::point_based {

/// A node while it is moved from its lattice point.
template <int D>
struct PlacedNode {
  Point<D> x;              ///< [m]
  std::int64_t point;      ///< lattice point that it comes from
  bool is_at_point;        ///< whether it has not moved
  bool may_move;           ///< whether it lies near the surface
  std::vector<int> faces;  ///< faces on which it lies
};

/// The part of the body nearest to each node.
template <int D>
struct NodeCells {
  std::vector<double> volumes;      ///< [node] [m^D]; they sum to that of the body
  std::vector<Point<D>> centroids;  ///< [node] [m]; the node itself where its volume is 0
};

template <int D>
NodeCells<D> cells_of(const BodyLattice<D>& lattice, const std::vector<PlacedNode<D>>& nodes);

extern template NodeCells<2> cells_of(const BodyLattice<2>&, const std::vector<PlacedNode<2>>&);
extern template NodeCells<3> cells_of(const BodyLattice<3>&, const std::vector<PlacedNode<3>>&);

}  // namespace pliant::point_based
