#pragma once

#include "engine/geometry/shape.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// [axis] the distance between lattice points: the one next to `spacing` [m] that divides the
/// extent of a shape.
template <int D>
Point<D> lattice_pitch(const Shape& shape, double spacing);

/// Nodes of the lattice of that pitch that lie in a shape, with nodes on all faces of a box. The
/// volumes are those of (PB.1): what the shape fills of the cell around a node; what it fills of
/// cells around lattice points outside belongs to the nearest nodes inside, so that volumes sum to
/// that of the shape. No nodes where the shape holds no lattice point.
template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing);

extern template Point<2> lattice_pitch<2>(const Shape&, double);
extern template Point<3> lattice_pitch<3>(const Shape&, double);
extern template NodeCloud<2> lattice_nodes<2>(const Shape&, double);
extern template NodeCloud<3> lattice_nodes<3>(const Shape&, double);

}  // namespace pliant::point_based
