#pragma once

#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Nodes of a square lattice that lie in a shape, with nodes on both faces of a box whose sides are
/// whole multiples of the spacing [m]. The volumes are those of (PB.1): what the shape fills of the
/// cell around a node; what it fills of cells around lattice points outside belongs to the nearest
/// nodes inside, so that volumes sum to that of the shape. No nodes where the shape holds no
/// lattice point.
template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing);

extern template NodeCloud<2> lattice_nodes<2>(const Shape&, double);
extern template NodeCloud<3> lattice_nodes<3>(const Shape&, double);

}  // namespace pliant::point_based
