#pragma once

#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Sizes of the cells of an octree (in 2D, a quadtree).
struct OctreeSizes {
  double finest = 0;    ///< size of cells that the surface crosses [m]
  double coarsest = 0;  ///< largest cell [m]; rounded down to a power of two times `finest`
  /// A cell at distance d from the surface is no larger than finest + growth d.
  double growth = 0.5;
};

/// Nodes of the leaves of an octree over the bounded shape `body`, dense at its surface and coarse
/// inside. A node lies at the centroid of the part of its leaf inside the body, and has its volume.
/// A part smaller than 0.3 of a leaf joins the largest neighbouring leaf at the surface, because
/// the smallest volume limits the time step. Equal sizes give a lattice of cell centres.
template <int D>
NodeCloud<D> octree_nodes(const Shape& body, const OctreeSizes& sizes);

extern template NodeCloud<2> octree_nodes<2>(const Shape&, const OctreeSizes&);
extern template NodeCloud<3> octree_nodes<3>(const Shape&, const OctreeSizes&);

}  // namespace pliant::point_based
