#pragma once

#include <array>
#include <vector>

#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// One node in plain numbers, for measurements and output.
template <int D>
struct NodeState {
  std::array<double, D* D> gradient = {};                            ///< F, row by row
  double volume_ratio = 1;                                           ///< J
  double pressure = 0;                                               ///< [Pa]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< sigma [Pa]
  double energy = 0;  ///< strain energy and stabilisation (PB.5) of the node [J]
};

/// The elastic state of the node at `slot` of a block, (PB.4)-(PB.7). Viscous stress is left out.
template <class T, int D>
NodeState<D> node_state(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot);

/// What the bonds of a node make of the displacements around it.
template <int D>
struct NodeFit {
  std::array<double, D* D> gradient = {};  ///< F_i of (PB.4), row by row
  double stabilisation = 0;                ///< energy (PB.5) [J]
};
template <class T, int D>
NodeFit<D> node_fit(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot);

/// F_i of (PB.4) alone, row by row.
template <class T, int D>
std::array<double, D * D> fitted_gradient(const Body<T, D>& body, const NodeBlock& block,
                                          std::int64_t slot);

/// F_i D of (PB.14): the gradient that has the strain energy of a node, from that of its bonds.
template <class T, int D>
std::array<double, D * D> with_kept(const Body<T, D>& body, std::int64_t slot,
                                    const std::array<double, D * D>& fit);

/// Strain energy [J] of a node at the gradient `f`.
template <class T, int D>
double strain_energy(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                     const std::array<double, D * D>& f);

/// F of (PB.4) at that node, row by row, with what it has kept at cuts (PB.14).
template <class T, int D>
std::array<double, D * D> present_gradient(const Body<T, D>& body, const NodeBlock& block,
                                           std::int64_t slot);

/// psi of (PB.6), (PB.7), or (RP.63), of the material of a body at the gradient `f`, per undeformed
/// volume [Pa].
template <class T, int D>
double strain_energy_density(const Body<T, D>& body, const std::array<double, D * D>& f);

/// Where the corners of the surface of a body are at present [m]: each moves with the node nearest
/// to it, as the gradient there says.
template <class T, int D>
std::vector<Point<D>> present_corners(const Body<T, D>& body);

/// Slots of one group: runs of `slots_per_group` in a pack.
template <int D>
std::int64_t first_of_group(std::int64_t slot) {
  return slot / kernels::slots_per_group<D> * kernels::slots_per_group<D>;
}

/// theta of (FE.2) at a node of a body with the gradient `f`.
template <class T, int D>
double dilatation(const Body<T, D>& body, const std::array<double, D * D>& f);

/// theta_g of (PB.60) at the node at `slot` of a block, which is in a group.
template <class T, int D>
double mean_dilatation(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot);

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

}  // namespace pliant::point_based
