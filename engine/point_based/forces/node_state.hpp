#pragma once

#include <array>
#include <vector>

#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// One node in plain numbers, for measurements and output.
template <int D>
struct NodeState {
  std::array<double, D* D> gradient = {};                            ///< F, row-major
  double volume_ratio = 1;                                           ///< J
  double pressure = 0;                                               ///< [Pa]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< sigma [Pa]
  double energy = 0;  ///< strain energy and stabilisation (PB.5) of the node [J]
};

/// The elastic state of the node at `slot` of a block, (PB.4)-(PB.7), without viscous stress.
template <class T, int D>
NodeState<D> node_state(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot);

/// The fit of a node's bonds to the displacements around it.
template <int D>
struct NodeFit {
  std::array<double, D* D> gradient = {};  ///< F_i of (PB.4), row-major
  double stabilisation = 0;                ///< energy (PB.5) [J]
};
template <class T, int D>
NodeFit<D> node_fit(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot);

/// Only F_i of (PB.4), row-major.
template <class T, int D>
std::array<double, D * D> fitted_gradient(const Body<T, D>& body, const NodeBlock& block,
                                          std::int64_t slot);

/// F_i D of (PB.14), from the fitted gradient F_i: the gradient that determines the strain energy
/// of a node.
template <class T, int D>
std::array<double, D * D> with_kept(const Body<T, D>& body, std::int64_t slot,
                                    const std::array<double, D * D>& fit);

/// Strain energy [J] of a node at the gradient `f`.
template <class T, int D>
double strain_energy(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                     const std::array<double, D * D>& f);

/// F of a node, row-major: the fit (PB.4) times what the node has kept at cuts (PB.14).
template <class T, int D>
std::array<double, D * D> present_gradient(const Body<T, D>& body, const NodeBlock& block,
                                           std::int64_t slot);

/// psi of (PB.6), (PB.7), or (RP.63) of a body's material at the gradient `f`, per undeformed
/// volume [Pa].
template <class T, int D>
double strain_energy_density(const Body<T, D>& body, const std::array<double, D * D>& f);

/// Present places of the corners of a body's surface [m]. Each moves with its nearest node, by the
/// gradient there.
template <class T, int D>
std::vector<Point<D>> present_corners(const Body<T, D>& body);

}  // namespace pliant::point_based
