#pragma once

#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Sizes of the cells of an octree (in 2D, a quadtree).
struct OctreeSizes {
  double finest = 0;    ///< size of cells that the surface crosses [m]
  double coarsest = 0;  ///< largest cell [m]; rounded down to a power of two times `finest`
  /// A cell at distance d from the surface or a cut is no larger than finest + growth d.
  double growth = 0.5;
};

/// Nodes at the corners of the leaves of an octree over the bounded shape `body`, dense at its
/// surface and coarse inside. Nodes near the surface are those of the lattice of the finest cells
/// and lie on the surface, see `lattice_nodes`. A node has the volume of the points nearest to it.
/// Equal sizes give that lattice. `cuts` are places of the surfaces that blades will sweep, no
/// farther apart than half of the finest cells, around which nodes are dense as well.
template <int D>
NodeCloud<D> octree_nodes(const Shape& body, const OctreeSizes& sizes,
                          const std::vector<Point<D>>& cuts = {});

extern template NodeCloud<2> octree_nodes<2>(const Shape&, const OctreeSizes&,
                                             const std::vector<Point<2>>&);
extern template NodeCloud<3> octree_nodes<3>(const Shape&, const OctreeSizes&,
                                             const std::vector<Point<3>>&);

}  // namespace pliant::point_based
