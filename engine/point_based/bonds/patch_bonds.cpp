#include "engine/point_based/bonds/patch_bonds.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <cmath>

#include "engine/point_based/bonds/chosen_bonds.hpp"
#include "engine/point_based/bonds/patch_weights.hpp"
#include "engine/point_based/surface/surface_shares.hpp"

namespace pliant::point_based {

namespace {

constexpr double on_surface = 1e-6;  // relative to the volume
constexpr double exact = 1e-5;       // relative to the stress

/// Whether the nodes span the body: then the sums of V I and a X^T are equal.
template <int D>
bool span_their_surface(const WeightedNodes<D>& nodes) {
  std::array<double, D* D> rest = {};
  double volume = 0;
  for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
    volume += nodes.volumes[i];
    for (int r = 0; r < D; ++r) {
      for (int c = 0; c < D; ++c) rest[D * r + c] += nodes.areas[i][r] * nodes.positions[i][c];
    }
  }
  for (int r = 0; r < D; ++r) rest[(D + 1) * r] -= volume;
  double square = 0;
  for (const double component : rest) square += component * component;
  return std::sqrt(square) < on_surface * volume;
}

/// Nodes with their bonds in the undeformed body.
template <class T, int D>
WeightedNodes<D> weighted_nodes(const NodeCloud<D>& cloud, const Body<T, D>& body,
                                const ChosenBonds<D>& bonds) {
  WeightedNodes<D> nodes;
  nodes.positions = cloud.positions;
  nodes.volumes = cloud.volumes;
  nodes.areas = surface_shares(body, [](const auto&, const auto&) { return BorneArea<D>{}; });
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    const auto node = static_cast<std::int64_t>(i);
    nodes.weight.push_back(bonds.weights(node));
    auto& neighbour = nodes.neighbour.emplace_back();
    for (std::size_t k = 0; k < nodes.weight[i].size(); ++k) {
      neighbour.push_back(bonds.neighbour(node, k));
    }
  }
  return nodes;
}

template <int D>
bool have_gradients(const WeightedNodes<D>& nodes, const ChosenBonds<D>& bonds) {
  for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
    if (bonds.gradient(static_cast<std::int64_t>(i)).rank < D) return false;
  }
  return true;
}

}  // namespace

template <class T, int D>
void correct_weights(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice,
                     scheduler::Workers& workers) {
  const ChosenBonds<D> bonds(cloud, choice);
  WeightedNodes<D> nodes = weighted_nodes(cloud, body, bonds);
  if (!span_their_surface(nodes)) {
    throw InputError(fmt::format(
        "the nodes of body `{}` do not lie on its surface, which point_based.gradient = "
        "\"patch_exact\" needs; take a mesh of tetrahedra, or a box of whole cells on a lattice",
        body.name));
  }
  if (!have_gradients(nodes, bonds) || !(make_patch_exact(nodes, workers) < exact)) {
    throw InputError(
        fmt::format("no weights of the bonds of body `{}` pass the patch test; give more "
                    "point_based.neighbours, or gradient = \"moving_least_squares\"",
                    body.name));
  }
  std::vector<std::vector<double>> factors;
  for (std::size_t i = 0; i < nodes.weight.size(); ++i) {
    factors.push_back(factors_of(nodes.weight[i], bonds.weights(static_cast<std::int64_t>(i))));
  }
  choice.correction = std::move(factors);
}

template void correct_weights(const NodeCloud<2>&, const Body<double, 2>&, BondChoice<2>&,
                              scheduler::Workers&);
template void correct_weights(const NodeCloud<3>&, const Body<double, 3>&, BondChoice<3>&,
                              scheduler::Workers&);
template void correct_weights(const NodeCloud<2>&, const Body<float, 2>&, BondChoice<2>&,
                              scheduler::Workers&);
template void correct_weights(const NodeCloud<3>&, const Body<float, 3>&, BondChoice<3>&,
                              scheduler::Workers&);

}  // namespace pliant::point_based
