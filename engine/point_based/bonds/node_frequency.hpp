#pragma once

#include <span>

#include "engine/point_based/body.hpp"

/// The highest frequency of a node and its neighbours, which limits the time step.
namespace pliant::point_based {

/// Constants of a node, besides its bonds, on which its frequency depends.
struct NodeMaterial {
  double lame_modulus, shear_modulus;  ///< [Pa]
  double volume;                       ///< V [m^D]
  double stiffness;                    ///< V kappa [N/m]
  double mass;                         ///< m [kg]
};

/// A bond of the node in this estimate.
template <int D>
struct BondStiffness {
  Point<D> gradient;  ///< g_ij [1/m]
  double weight;      ///< w_ij
  double mass;        ///< of the neighbour [kg]
};

/// lambda_i of (PB.12) [1/s^2]: the highest squared frequency of a node and its neighbours, at
/// rest, if only this node has an energy.
template <int D>
double node_frequency2(const NodeMaterial& node, std::span<const BondStiffness<D>> bonds);

/// The factor of lambda_i in (PB.12) on lattices: how many energies act on a node.
inline constexpr double energies_of_node = 2;

/// The factor, at least 1, by which nodes stiffen each other more than on lattices, if small nodes
/// are next to large ones; by power iteration, at rest. Requires the bonds.
template <class T, int D>
double joint_frequency_factor(const Body<T, D>& body);

extern template double node_frequency2<2>(const NodeMaterial&, std::span<const BondStiffness<2>>);
extern template double node_frequency2<3>(const NodeMaterial&, std::span<const BondStiffness<3>>);

}  // namespace pliant::point_based
