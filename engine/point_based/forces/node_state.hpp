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

/// Strain energy [J] of a node at the gradient `f`.
template <class T, int D>
double strain_energy(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot,
                     const std::array<double, D * D>& f);

/// psi of (PB.6), (PB.7), or (RP.63) of a body's material at the gradient `f`, per undeformed
/// volume [Pa].
template <class T, int D>
double strain_energy_density(const Body<T, D>& body, const std::array<double, D * D>& f);

/// Present places of the corners of a body's surface [m]. Each moves with its nearest node, by the
/// gradient there.
template <class T, int D>
std::vector<Point<D>> present_corners(const Body<T, D>& body);

}  // namespace pliant::point_based
