#pragma once

#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Sizes of the cells of an octree (in 2D, a quadtree).
struct OctreeSizes {
  double finest = 0;    ///< cells that the surface crosses [m]
  double coarsest = 0;  ///< no cell is larger [m]; rounded down to a power of two times `finest`
  /// A cell at distance d from the surface is no larger than finest + growth d.
  double growth = 0.5;
};

/// Nodes at the corners of the leaves of an octree over the bounded shape `body`: dense at its
/// surface, coarse inside. Those near the surface are nodes of the lattice of the finest cells, and
/// lie on it as `lattice_nodes` has them. Volumes are what is nearest to a node. Equal sizes give
/// that lattice.
template <int D>
NodeCloud<D> octree_nodes(const Shape& body, const OctreeSizes& sizes);

extern template NodeCloud<2> octree_nodes<2>(const Shape&, const OctreeSizes&);
extern template NodeCloud<3> octree_nodes<3>(const Shape&, const OctreeSizes&);

}  // namespace pliant::point_based
