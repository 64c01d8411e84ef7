#pragma once

#include <vector>

#include "engine/point_based/body.hpp"

/// Groups of nodes that share the stiff part of their pressure, (PB.60). Without groups, irregular
/// nodes, and those of a lattice that is squeezed, resist even deformations that preserve the
/// volume.
namespace pliant::point_based {

/// Forms the groups of a body with bonds, if its material has a stiff part. In 2D the nodes of a
/// lattice form none, docs/decisions/0043.
template <class T, int D>
void form_groups(bool is_lattice, Body<T, D>& body);

/// Dissolves the group of a node, if it has one, and appends the slots of the group to `members`.
template <class T, int D>
void dissolve_group(std::int64_t slot, Body<T, D>& body, std::vector<std::int32_t>& members);

/// The same, but each node keeps the theta of the group by (PB.14). Returns the change of the
/// strain energy [J].
template <class T, int D>
double dissolve_group_gently(std::int64_t slot, Body<T, D>& body,
                             std::vector<std::int32_t>& members);

}  // namespace pliant::point_based
