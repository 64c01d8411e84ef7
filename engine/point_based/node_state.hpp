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

}  // namespace pliant::point_based
