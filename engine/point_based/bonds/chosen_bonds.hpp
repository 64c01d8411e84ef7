#pragma once

#include <span>
#include <vector>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/bonds/node_operator.hpp"

namespace pliant::point_based {

/// The bonds that nodes of a cloud have chosen, without corrections of their weights.
template <int D>
class ChosenBonds {
 public:
  /// Keeps references.
  ChosenBonds(const NodeCloud<D>& cloud, const BondChoice<D>& choice)
      : cloud_(cloud), choice_(choice) {}

  std::vector<double> weights(std::int64_t node) const { return weights_of(choice_, node); }
  std::int32_t neighbour(std::int64_t node, std::size_t bond) const {
    return choice_.candidates[node][bond].node;
  }
  const Point<D>& place(std::int64_t node) const { return cloud_.positions[node]; }

  NodeOperator<D> gradient(std::int64_t node) const {
    const std::vector<double> weights = this->weights(node);
    std::vector<Point<D>> bonds;
    bonds.reserve(weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k) {
      bonds.push_back(difference<D>(place(neighbour(node, k)), place(node)));
    }
    return node_operator<D>(bonds, weights);
  }

 private:
  const NodeCloud<D>& cloud_;
  const BondChoice<D>& choice_;
};

/// Sets how corners move that lie beside their nodes, by the present weights.
template <class T, int D>
void fit_surface(const ChosenBonds<D>& bonds, std::span<const std::int64_t> slot_of,
                 Body<T, D>& body) {
  for (const std::int32_t slot : body.surface.node) {
    const auto [at, is_new] = body.surface.fit.insert({slot, {}});
    if (!is_new) continue;
    const std::int64_t node = body.number[slot];
    at->second.gradient = bonds.gradient(node).gradient;
    for (std::size_t k = 0; k < at->second.gradient.size(); ++k) {
      at->second.slot.push_back(static_cast<std::int32_t>(slot_of[bonds.neighbour(node, k)]));
    }
  }
}

}  // namespace pliant::point_based
