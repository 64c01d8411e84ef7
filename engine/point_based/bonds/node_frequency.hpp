#pragma once

#include <span>

#include "engine/point_based/body.hpp"

/// How fast a node and its neighbours can swing.
namespace pliant::point_based {

/// What the frequency of a node depends on, besides its bonds.
struct NodeMaterial {
  double lame_modulus, shear_modulus;  ///< [Pa]
  double volume;                       ///< V [m^D]
  double stiffness;                    ///< V kappa [N/m]
  double mass;                         ///< m [kg]
};

/// A bond of the node.
template <int D>
struct SwingingBond {
  Point<D> gradient;  ///< g_ij [1/m]
  double weight;      ///< w_ij
  double mass;        ///< of the neighbour [kg]
};

/// lambda_i of (PB.12) [1/s^2]: the highest squared frequency of a node and its neighbours, at
/// rest, under the energy of this node alone.
template <int D>
double node_frequency2(const NodeMaterial& node, std::span<const SwingingBond<D>> bonds);

/// The factor of lambda_i in (PB.12) on lattices.
inline constexpr double energies_of_node = 2;

/// By how much more than that the nodes of a body whose bonds are known stiffen each other, 1 at
/// least: where small nodes lie next to large ones. By power iteration, at rest.
template <class T, int D>
double crowding(const Body<T, D>& body);

extern template double node_frequency2<2>(const NodeMaterial&, std::span<const SwingingBond<2>>);
extern template double node_frequency2<3>(const NodeMaterial&, std::span<const SwingingBond<3>>);

}  // namespace pliant::point_based
