#pragma once

#include <functional>
#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/point_based/nodes/body_lattice.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Nodes of the lattice of `lattice_pitch` that lie in a shape, moved to where (PB.40) has them:
/// those within half of the pitch of the surface lie on it, as do points outside, and edges and
/// corners of the shape have nodes where its faces meet. All points of a box stay where they are.
/// The volumes are those of (PB.1), and sum to that of the shape. No nodes where the shape is
/// thinner than the lattice can see.
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
