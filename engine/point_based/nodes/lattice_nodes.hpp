#pragma once

#include <functional>
#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/body_lattice.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Nodes on the lattice of `lattice_pitch` inside a shape, moved by (PB.40). Points within half a
/// pitch of the surface move onto it, also from outside. Edges and corners of the shape get nodes
/// where its faces meet. Points of a box do not move. The volumes are those of (PB.1); their sum is
/// the volume of the shape. There are no nodes where the shape is too thin for the lattice.
template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing);

/// [lattice point] whether it may become a node.
template <int D>
using PointChoice = std::function<std::vector<bool>(const BodyLattice<D>&)>;

/// The same with some of the lattice points alone; all near the surface must be among them.
template <int D>
NodeCloud<D> lattice_nodes(const Shape& shape, double spacing, const PointChoice<D>& choice);

extern template NodeCloud<2> lattice_nodes<2>(const Shape&, double);
extern template NodeCloud<3> lattice_nodes<3>(const Shape&, double);
extern template NodeCloud<2> lattice_nodes<2>(const Shape&, double, const PointChoice<2>&);
extern template NodeCloud<3> lattice_nodes<3>(const Shape&, double, const PointChoice<3>&);

}  // namespace pliant::point_based
