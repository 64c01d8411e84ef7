#pragma once

#include <array>
#include <vector>

#include "engine/point_based/body.hpp"

/// Groups of irregular nodes that share the stiff part of their pressure, (PB.60): such nodes would
/// else resist deformations that keep the volume.
namespace pliant::point_based {

/// Slots of one group: runs of `slots_per_group` in a pack.
template <int D>
std::int64_t first_of_group(std::int64_t slot) {
  return slot / kernels::slots_per_group<D> * kernels::slots_per_group<D>;
}

/// Forms the groups of a body whose bonds are known, where its material has a stiff part.
template <class T, int D>
void form_groups(Body<T, D>& body);

/// What its group changes at one node.
template <int D>
struct SharedPressure {
  double slope = 0;                                                  ///< of psi by theta [Pa]
  double energy = 0;                                                 ///< [J]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< sigma [Pa]
  double pressure = 0;                                               ///< [Pa]
};

/// At the node at `slot` of a block, whose deformation gradient is `f`.
template <class T, int D>
SharedPressure<D> shared_pressure(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                                  const std::array<double, D * D>& f);

/// Dissolves the group of a node, if it has one, and appends its slots to `members`.
template <class T, int D>
void dissolve_group(std::int64_t slot, Body<T, D>& body, std::vector<std::int32_t>& members);

/// The same; each node keeps the theta of the group by (PB.14). Returns by how much that changes
/// the strain energy [J].
template <class T, int D>
double dissolve_group_gently(std::int64_t slot, Body<T, D>& body,
                             std::vector<std::int32_t>& members);

}  // namespace pliant::point_based
