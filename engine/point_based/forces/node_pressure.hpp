#pragma once

#include <array>

#include "engine/method/bulk_history.hpp"
#include "engine/point_based/body.hpp"

/// Parts of the pressure of a node in plain numbers that depend on more than its own gradient: what
/// its group shares, (PB.60), and what relaxes in time, (PB.70).
namespace pliant::point_based {

/// First slot of the group of a slot: a pack holds runs of `slots_per_group`.
template <int D>
std::int64_t first_of_group(std::int64_t slot) {
  return slot / kernels::slots_per_group<D> * kernels::slots_per_group<D>;
}

/// theta of (FE.2) at a node of a body with the gradient `f`.
template <class T, int D>
double dilatation(const Body<T, D>& body, const std::array<double, D * D>& f);

/// theta_g of (PB.60) at the node at `slot` of a block; it must be in a group.
template <class T, int D>
double mean_dilatation(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot);

/// The contribution of its group to a node.
template <int D>
struct SharedPressure {
  double slope = 0;                                                  ///< d psi/d theta [Pa]
  double energy = 0;                                                 ///< [J]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< sigma [Pa]
  double pressure = 0;                                               ///< [Pa]
};

/// The contribution at the node at `slot` of a block, whose deformation gradient is `f`.
template <class T, int D>
SharedPressure<D> shared_pressure(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                                  const std::array<double, D * D>& f);

/// What has relaxed at the node at `slot` of a block, whose deformation gradient is `f`.
template <class T, int D>
RelaxedPressure relaxed_pressure(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                                 const std::array<double, D * D>& f);

}  // namespace pliant::point_based
