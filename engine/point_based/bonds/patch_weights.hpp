#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// Nodes with weighted bonds, and their shares of the body's surface.
template <int D>
struct WeightedNodes {
  std::vector<Point<D>> positions;                   ///< [node] [m]
  std::vector<double> volumes;                       ///< [node] V [m^D]
  std::vector<Point<D>> areas;                       ///< [node] a, outwards [m^(D-1)]
  std::vector<std::vector<std::int32_t>> neighbour;  ///< [node][bond] may be empty
  std::vector<std::vector<double>> weight;           ///< [node][bond] positive
  /// [node] row-major projection onto the directions in which no wall takes the force; empty: all
  std::vector<std::array<double, D * D>> free;
};

/// [bond] the factors by which weights have changed.
inline std::vector<double> factors_of(const std::vector<double>& now,
                                      const std::vector<double>& before) {
  std::vector<double> factors;
  factors.reserve(before.size());
  for (std::size_t k = 0; k < now.size(); ++k) factors.push_back(now[k] / before[k]);
  return factors;
}

/// Makes the gradients of (PB.3) exact for uniform stress by the smallest change of the weights,
/// (PB.17). The sums of V I and of a_i X_i^T must be equal. Returns the largest remaining force on
/// a node, in units of the stress times V^((D-1)/D).
template <int D>
double make_patch_exact(WeightedNodes<D>& nodes);

/// Changes the weights so that a uniform stress exerts little force on nodes that are not held,
/// (PB.61), at most `balanced` in units of the stress times V^((D-1)/D) if a few steps suffice. No
/// weight changes by more than the factor `most_change`, or its inverse.
template <int D>
void balance_weights(WeightedNodes<D>& nodes, double most_change, double balanced);

extern template void balance_weights<2>(WeightedNodes<2>&, double, double);
extern template void balance_weights<3>(WeightedNodes<3>&, double, double);
extern template double make_patch_exact<2>(WeightedNodes<2>&);
extern template double make_patch_exact<3>(WeightedNodes<3>&);

}  // namespace pliant::point_based
