#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Largest lambda/mu that counts in (PB.5) and (PB.60): that of nu = 0.3.
inline constexpr double stiff_lame_over_shear = 1.5;

/// How nodes choose their neighbours.
template <int D>
struct BondChoice {
  using Found = typename NearestNodes<D>::Found;
  std::vector<std::vector<Found>> candidates;  ///< [node of the cloud] nearest first
  std::vector<std::int64_t> slot_of;           ///< [node of the cloud]
  std::vector<double> elastic_volumes;         ///< [node of the cloud] of (PB.21) [m^D]
  int neighbours = 0;                          ///< most neighbours of a node
  double support = 0;  ///< h of (PB.2) [m]; infinite: distance of the next candidate
  double alpha = 0;    ///< strength of the stabilisation (PB.5)
  /// [node of the cloud][candidate] factors of the weights, (PB.17) and (PB.61); none: 1.
  std::vector<std::vector<double>> correction;
  double joint_frequency_factor = 1;  ///< factor of lambda_i, (PB.12)
  bool may_change = false;            ///< whether cuts may make any candidate a neighbour

  double correction_of(std::int64_t node, std::size_t candidate) const {
    const bool has_factor = !correction.empty() && candidate < correction[node].size();
    return has_factor ? correction[node][candidate] : 1;
  }
  bool is_lattice() const { return !std::isinf(support); }
};

/// The ratio of support radius to spacing that gives a node inside a lattice `count` neighbours,
/// (PB.2).
template <int D>
double lattice_support(int count);

/// Weights of the bonds of a node to its first candidates, (PB.2).
template <int D>
std::vector<double> weights_of(const BondChoice<D>& choice, std::int64_t node);

/// Makes the bonds of a body from its blocks, places and volumes, (PB.2)-(PB.3): neighbours,
/// gradients, moments, halos, and the adjacency of blocks.
template <class T, int D>
void make_bonds(const BondChoice<D>& choice, Body<T, D>& body);

/// Bonds of a node that do not follow from (PB.2)-(PB.3).
template <int D>
struct GivenBonds {
  std::vector<std::int64_t> slot;  ///< of the neighbours
  std::vector<Point<D>> gradient;  ///< g_ij [1/m]
};

/// The same with given bonds [slot], all of weight 1, without stabilisation.
template <class T, int D>
void make_bonds(const std::vector<GivenBonds<D>>& bonds, Body<T, D>& body);

/// Sets the bonds of one node: to the nearest of its candidates with a factor other than 0.
/// `factors`, one for each candidate, multiply the weights; empty: all are 1.
template <class T, int D>
void set_bonds(const BondChoice<D>& choice, std::span<const double> factors, std::int64_t slot,
               Body<T, D>& body);

}  // namespace pliant::point_based
