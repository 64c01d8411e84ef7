#include "engine/point_based/bonds/patch_bonds.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <cmath>

#include "engine/point_based/bonds/node_operator.hpp"
#include "engine/point_based/bonds/patch_weights.hpp"

namespace pliant::point_based {

namespace {

constexpr double on_surface = 1e-6;  // of the volume
constexpr double exact = 1e-5;       // of the stress

/// [node of the cloud] its share of the surface, outwards [m^(D-1)]
template <class T, int D>
std::vector<Point<D>> areas_of(const NodeCloud<D>& cloud, const Body<T, D>& body) {
  std::vector<Point<D>> areas(cloud.positions.size());
  for (const auto& facet : body.surface.facet) {
    std::array<Point<D>, D> corner;
    for (int v = 0; v < D; ++v) corner[v] = body.surface.start[facet[v]];
    const Point<D> area = undeformed::area_vector<D>(corner);
    for (const std::int32_t c : facet) {
      Point<D>& share = areas[body.number[body.surface.node[c]]];
      for (int a = 0; a < D; ++a) share[a] += area[a] / D;
    }
  }
  return areas;
}

/// The sums of V I and a X^T are equal where the nodes span the body.
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
bool has_gradients(const WeightedNodes<D>& nodes) {
  for (std::size_t i = 0; i < nodes.positions.size(); ++i) {
    std::vector<Point<D>> bonds;
    bonds.reserve(nodes.neighbour[i].size());
    for (const std::int32_t j : nodes.neighbour[i]) {
      Point<D>& x = bonds.emplace_back();
      for (int a = 0; a < D; ++a) x[a] = nodes.positions[j][a] - nodes.positions[i][a];
    }
    if (node_operator<D>(bonds, nodes.weight[i]).rank < D) return false;
  }
  return true;
}

}  // namespace

template <class T, int D>
void correct_weights(const NodeCloud<D>& cloud, const Body<T, D>& body, BondChoice<D>& choice) {
  WeightedNodes<D> nodes;
  nodes.positions = cloud.positions;
  nodes.volumes = cloud.volumes;
  nodes.areas = areas_of(cloud, body);
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    nodes.weight.push_back(weights_of(choice, static_cast<std::int64_t>(i)));
    auto& neighbour = nodes.neighbour.emplace_back();
    for (std::size_t k = 0; k < nodes.weight[i].size(); ++k) {
      neighbour.push_back(choice.candidates[i][k].node);
    }
  }
  if (!span_their_surface(nodes)) {
    throw InputError(fmt::format(
        "the nodes of body `{}` do not lie on its surface, which point_based.gradient = "
        "\"patch_exact\" needs; take a mesh of tetrahedra, or a box of whole cells on a lattice",
        body.name));
  }
  const std::vector<std::vector<double>> before = nodes.weight;
  if (!has_gradients(nodes) || !(make_patch_exact(nodes) < exact)) {
    throw InputError(
        fmt::format("no weights of the bonds of body `{}` pass the patch test; give more "
                    "point_based.neighbours, or gradient = \"moving_least_squares\"",
                    body.name));
  }
  choice.correction.resize(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    choice.correction[i].assign(choice.candidates[i].size(), 1);
    for (std::size_t k = 0; k < before[i].size(); ++k) {
      choice.correction[i][k] = nodes.weight[i][k] / before[i][k];
    }
  }
}

template void correct_weights(const NodeCloud<2>&, const Body<double, 2>&, BondChoice<2>&);
template void correct_weights(const NodeCloud<3>&, const Body<double, 3>&, BondChoice<3>&);
template void correct_weights(const NodeCloud<2>&, const Body<float, 2>&, BondChoice<2>&);
template void correct_weights(const NodeCloud<3>&, const Body<float, 3>&, BondChoice<3>&);

}  // namespace pliant::point_based
