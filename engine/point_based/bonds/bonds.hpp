#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// What (PB.5) and (PB.60) take of lambda, over mu; that of nu = 0.3.
inline constexpr double stiff_lame_over_shear = 1.5;

/// From which nodes a node takes its neighbours, and how.
template <int D>
struct BondChoice {
  using Found = typename NearestNodes<D>::Found;
  std::vector<std::vector<Found>> candidates;  ///< [node of the cloud] nearest first
  std::vector<std::int64_t> slot_of;           ///< [node of the cloud]
  std::vector<double> elastic_volumes;         ///< [node of the cloud] of (PB.21) [m^D]
  int neighbours = 0;                          ///< of each node, at most
  double support = 0;  ///< h of (PB.2) [m]; infinite: from the next candidate
  double alpha = 0;    ///< strength of the stabilisation (PB.5)
  /// [node of the cloud][candidate] factors of the weights, (PB.17) and (PB.61); none: 1.
  std::vector<std::vector<double>> correction;
  double crowding = 1;      ///< factor of lambda_i, (PB.12)
  bool may_change = false;  ///< any candidate may become a neighbour when others are cut off

  double correction_of(std::int64_t node, std::size_t candidate) const {
    const bool has_factor = !correction.empty() && candidate < correction[node].size();
    return has_factor ? correction[node][candidate] : 1;
  }
  bool is_lattice() const { return !std::isinf(support); }
};

/// The support radius over the spacing that gives a node inside a lattice `count` neighbours,
/// (PB.2).
template <int D>
double lattice_support(int count);

/// Weights of the bonds of a node to its first candidates, (PB.2).
template <int D>
std::vector<double> weights_of(const BondChoice<D>& choice, std::int64_t node);

/// Bonds between the nodes of a body whose blocks, places and volumes are known, (PB.2)-(PB.3):
/// neighbours, gradients, moments, halos, and which blocks are near each other.
template <class T, int D>
void make_bonds(const BondChoice<D>& choice, Body<T, D>& body);

/// Bonds of a node that do not follow from (PB.2)-(PB.3).
template <int D>
struct GivenBonds {
  std::vector<std::int64_t> slot;  ///< of the neighbours
  std::vector<Point<D>> gradient;  ///< g_ij [1/m]
};

/// The same with given bonds, [slot], all of weight 1, and without stabilisation.
template <class T, int D>
void make_bonds(const std::vector<GivenBonds<D>>& bonds, Body<T, D>& body);

/// Bonds of one node: to the nearest of its candidates whose factor is not 0. `factors`, one for
/// each candidate, multiply weights; none: all are 1.
template <class T, int D>
void set_bonds(const BondChoice<D>& choice, std::span<const double> factors, std::int64_t slot,
               Body<T, D>& body);

}  // namespace pliant::point_based
