#include "engine/point_based/bonds/patch_bonds.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/bonds/node_operator.hpp"
#include "engine/point_based/bonds/patch_weights.hpp"

namespace pliant::point_based {

namespace {

constexpr double on_surface = 1e-6;  // relative to the volume
constexpr double exact = 1e-5;       // relative to the stress

template <int D>
using Operators = std::vector<NodeOperator<D>>;

/// [node of the cloud] its share of the surface, outward [m^(D-1)]. A corner of a facet that is no
/// node moves by (TL.15).
template <class T, int D>
std::vector<Point<D>> areas_of(const Body<T, D>& body, const WeightedNodes<D>& nodes,
                               const Operators<D>& operators) {
  std::vector<Point<D>> areas(nodes.positions.size());
  const auto add = [&areas](std::int64_t node, double weight, const Point<D>& area) {
    for (int a = 0; a < D; ++a) areas[node][a] += weight / D * area[a];
  };
  for (const auto& facet : body.surface.facet) {
    std::array<Point<D>, D> corner;
    for (int v = 0; v < D; ++v) corner[v] = body.surface.start[facet[v]];
    const Point<D> area = undeformed::area_vector<D>(corner);
    for (int v = 0; v < D; ++v) {
      const std::int64_t i = body.number[body.surface.node[facet[v]]];
      const Point<D> from = difference<D>(corner[v], nodes.positions[i]);
      add(i, 1, area);
      for (std::size_t k = 0; k < nodes.neighbour[i].size(); ++k) {
        const double share = dot<D>(operators[i].gradient[k], from);
        add(nodes.neighbour[i][k], share, area);
        add(i, -share, area);
      }
    }
  }
  return areas;
}

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

template <int D>
Operators<D> operators_of(const WeightedNodes<D>& nodes) {
  Operators<D> operators;
  for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
    std::vector<Point<D>> bonds;
    bonds.reserve(nodes.neighbour[i].size());
    for (const std::int32_t j : nodes.neighbour[i]) {
      bonds.push_back(difference<D>(nodes.positions[j], nodes.positions[i]));
    }
    operators.push_back(node_operator<D>(bonds, nodes.weight[i]));
  }
  return operators;
}

template <int D>
bool have_gradients(const Operators<D>& operators) {
  return std::ranges::all_of(operators, [](const auto& made) { return made.rank == D; });
}

/// Nodes with their bonds in the undeformed body, without areas.
template <int D>
WeightedNodes<D> weighted_nodes(const NodeCloud<D>& cloud, const BondChoice<D>& choice) {
  WeightedNodes<D> nodes;
  nodes.positions = cloud.positions;
  nodes.volumes = cloud.volumes;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    nodes.weight.push_back(weights_of(choice, static_cast<std::int64_t>(i)));
    auto& neighbour = nodes.neighbour.emplace_back();
    for (std::size_t k = 0; k < nodes.weight[i].size(); ++k) {
      neighbour.push_back(choice.candidates[i][k].node);
    }
  }
  return nodes;
}

template <int D>
void keep_factors(const std::vector<std::vector<double>>& before, const WeightedNodes<D>& nodes,
                  BondChoice<D>& choice) {
  choice.correction = before;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t k = 0; k < before[i].size(); ++k) {
      choice.correction[i][k] = nodes.weight[i][k] / before[i][k];
    }
  }
}

/// Marks nodes as held that take forces of walls or of degenerate nodes. Removes the bonds of nodes
/// without elastic volume or gradient.
template <class T, int D>
void leave_out(const Body<T, D>& body, const NodeCloud<D>& cloud, const Operators<D>& operators,
               const BondChoice<D>& choice, WeightedNodes<D>& nodes) {
  nodes.is_held.assign(nodes.positions.size(), false);
  for (const auto& of_block : body.held) {
    for (const auto& held : of_block) {
      if (held.normal == Point<D>{}) nodes.is_held[body.number[held.slot]] = true;
    }
  }
  for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
    nodes.volumes[i] = choice.elastic_volumes[i];
    if (nodes.volumes[i] < cloud.volumes[i] || operators[i].rank < D) nodes.is_held[i] = true;
    if (nodes.volumes[i] > 0 && operators[i].rank == D) continue;
    nodes.neighbour[i].clear();
    nodes.weight[i].clear();
  }
}

}  // namespace

template <class T, int D>
void correct_weights(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice) {
  WeightedNodes<D> nodes = weighted_nodes(cloud, choice);
  const Operators<D> operators = operators_of(nodes);
  nodes.areas = areas_of(body, nodes, operators);
  if (!span_their_surface(nodes)) {
    throw InputError(fmt::format(
        "the nodes of body `{}` do not lie on its surface, which point_based.gradient = "
        "\"patch_exact\" needs; take a mesh of tetrahedra, or a box of whole cells on a lattice",
        body.name));
  }
  const std::vector<std::vector<double>> before = nodes.weight;
  if (!have_gradients<D>(operators) || !(make_patch_exact(nodes) < exact)) {
    throw InputError(
        fmt::format("no weights of the bonds of body `{}` pass the patch test; give more "
                    "point_based.neighbours, or gradient = \"moving_least_squares\"",
                    body.name));
  }
  keep_factors(before, nodes, choice);
}

template <class T, int D>
void balance_bonds(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice) {
  WeightedNodes<D> nodes = weighted_nodes(cloud, choice);
  const Operators<D> operators = operators_of(nodes);
  nodes.areas = areas_of(body, nodes, operators);
  leave_out(body, cloud, operators, choice, nodes);
  const std::vector<std::vector<double>> before = nodes.weight;
  balance_weights(nodes);
  keep_factors(before, nodes, choice);
}

template void correct_weights(const NodeCloud<2>&, const Body<double, 2>&, BondChoice<2>&);
template void correct_weights(const NodeCloud<3>&, const Body<double, 3>&, BondChoice<3>&);
template void correct_weights(const NodeCloud<2>&, const Body<float, 2>&, BondChoice<2>&);
template void correct_weights(const NodeCloud<3>&, const Body<float, 3>&, BondChoice<3>&);
template void balance_bonds(const NodeCloud<2>&, const Body<double, 2>&, BondChoice<2>&);
template void balance_bonds(const NodeCloud<3>&, const Body<double, 3>&, BondChoice<3>&);
template void balance_bonds(const NodeCloud<2>&, const Body<float, 2>&, BondChoice<2>&);
template void balance_bonds(const NodeCloud<3>&, const Body<float, 3>&, BondChoice<3>&);

}  // namespace pliant::point_based
