#pragma once

#include <cstddef>
#include <vector>

#include "engine/point_based/bonds/weighted_nodes.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

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
double make_patch_exact(WeightedNodes<D>& nodes, scheduler::Workers& workers);

/// Changes the weights so that a uniform stress exerts little force on nodes that are not held,
/// (PB.61), at most `balanced` in units of the stress times V^((D-1)/D) if a few steps suffice. No
/// weight changes by more than the factor `most_change`, or its inverse.
template <int D>
void balance_weights(WeightedNodes<D>& nodes, double most_change, double balanced,
                     scheduler::Workers& workers);

extern template void balance_weights(WeightedNodes<2>&, double, double, scheduler::Workers&);
extern template void balance_weights(WeightedNodes<3>&, double, double, scheduler::Workers&);
extern template double make_patch_exact(WeightedNodes<2>&, scheduler::Workers&);
extern template double make_patch_exact(WeightedNodes<3>&, scheduler::Workers&);

}  // namespace pliant::point_based
