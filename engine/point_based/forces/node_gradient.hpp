#pragma once

#include <array>
#include <cstdint>

#include "engine/point_based/body.hpp"

/// Deformation gradients of nodes in plain numbers, for measurements and output.
namespace pliant::point_based {

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

/// F of a node, row-major: the fit (PB.4) times what the node has kept at cuts (PB.14).
template <class T, int D>
std::array<double, D * D> present_gradient(const Body<T, D>& body, const NodeBlock& block,
                                           std::int64_t slot);

}  // namespace pliant::point_based
