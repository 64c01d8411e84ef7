#include "engine/point_based/forces/node_groups.hpp"

#include <algorithm>
#include <cmath>

#include "engine/method/hyperelastic.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/forces/node_gradient.hpp"
#include "engine/point_based/forces/node_pressure.hpp"
#include "engine/point_based/forces/node_state.hpp"

namespace pliant::point_based {

namespace {

/// Largest lambda/mu that nodes of a lattice have for themselves: that of nu = 0.4.
constexpr double own_lame_over_shear_on_lattices = 4;

template <int D>
using Gradient = std::array<double, D * D>;

/// The factor of F that changes theta to `wanted`.
template <class T, int D>
double scale_to(const Body<T, D>& body, double theta, double wanted) {
  if (body.material.law == kernels::ElasticLaw::st_venant_kirchhoff) {
    return std::sqrt((2 * wanted + D) / (2 * theta + D));
  }
  return std::pow((1 + wanted) / (1 + theta), 1. / D);
}

template <class T, int D>
bool are_bonded(const Body<T, D>& body, const NodeBlock& block, std::int64_t one,
                std::int64_t other) {
  bool found = false;
  const auto look = [&](std::int64_t from, std::int64_t to) {
    body.for_each_bond(block, from, [&](int, std::int64_t slot, const Point<D>&, double) {
      found = found || slot == to;
    });
  };
  look(one, other);
  look(other, one);
  return found;
}

/// The longest run of slots in a group in which each node has a bond to the next: first and last +
/// 1.
template <class T, int D>
std::pair<std::int64_t, std::int64_t> longest_run(const Body<T, D>& body, const NodeBlock& block,
                                                  std::int64_t first) {
  const std::int64_t end =
      std::min(first + kernels::slots_per_group<D>, block.first + std::int64_t{block.nodes});
  std::pair<std::int64_t, std::int64_t> longest = {first, first};
  for (std::int64_t begin = first; begin < end;) {
    std::int64_t next = begin;
    while (next < end && body.volume[next] > 0 &&
           (next == begin || are_bonded(body, block, next - 1, next))) {
      ++next;
    }
    if (next - begin > longest.second - longest.first) longest = {begin, next};
    begin = std::max(next, begin + 1);
  }
  return longest;
}

}  // namespace

template <class T, int D>
void form_groups(bool is_lattice, Body<T, D>& body) {
  if (is_lattice && D == 2) return;
  const double own = is_lattice ? own_lame_over_shear_on_lattices : stiff_lame_over_shear;
  const double mu = long_term_share(body.prony_shear) * body.material.shear_modulus;
  const double modulus = body.material.lame_modulus - own * mu;
  if (!(modulus > 0)) return;
  body.shared_modulus = static_cast<T>(modulus);
  body.share.grow(body.slots, T(0));
  for (const NodeBlock& block : body.blocks) {
    for (std::int64_t first = block.first; first < block.first + block.count;
         first += kernels::slots_per_group<D>) {
      const auto [begin, end] = longest_run(body, block, first);
      if (end - begin < 2) continue;
      double volume = 0;
      for (std::int64_t slot = begin; slot < end; ++slot) volume += body.volume[slot];
      for (std::int64_t slot = begin; slot < end; ++slot) {
        body.share[slot] = static_cast<T>(body.volume[slot] / volume);
      }
    }
  }
}

template <class T, int D>
void dissolve_group(std::int64_t slot, Body<T, D>& body, std::vector<std::int32_t>& members) {
  if (!body.has_groups() || !(body.share[slot] > 0)) return;
  const std::int64_t first = first_of_group<D>(slot);
  for (std::int64_t s = first; s < first + kernels::slots_per_group<D>; ++s) {
    if (!(body.share[s] > 0)) continue;
    body.share[s] = 0;
    members.push_back(static_cast<std::int32_t>(s));
  }
}

template <class T, int D>
double dissolve_group_gently(std::int64_t slot, Body<T, D>& body,
                             std::vector<std::int32_t>& members) {
  if (!body.has_groups() || !(body.share[slot] > 0)) return 0;
  const NodeBlock& block = body.block_of(slot);
  const double mean = mean_dilatation(body, block, slot);
  const std::size_t before = members.size();
  double added = 0;
  const std::int64_t first = first_of_group<D>(slot);
  for (std::int64_t s = first; s < first + kernels::slots_per_group<D>; ++s) {
    if (!(body.share[s] > 0)) continue;
    const Gradient<D> fit = fitted_gradient(body, block, s);
    added -= body.volume[s] * strain_energy_density(body, fit);
    added -= shared_pressure(body, block, s, fit).energy;
  }
  dissolve_group(slot, body, members);
  for (std::size_t m = before; m < members.size(); ++m) {
    const std::int32_t s = members[m];
    Gradient<D> kept = fitted_gradient(body, block, s);
    const double scale = scale_to(body, dilatation(body, kept), mean);
    for (double& component : kept) component *= scale;
    added += body.volume[s] * strain_energy_density(body, kept);
    for (int a = 0; a < D; ++a) body.kept_gradient[(D + 1) * a][s] = static_cast<T>(scale);
  }
  return added;
}

template void form_groups(bool, Body<double, 2>&);
template void form_groups(bool, Body<double, 3>&);
template void form_groups(bool, Body<float, 2>&);
template void form_groups(bool, Body<float, 3>&);
template void dissolve_group(std::int64_t, Body<double, 2>&, std::vector<std::int32_t>&);
template void dissolve_group(std::int64_t, Body<double, 3>&, std::vector<std::int32_t>&);
template void dissolve_group(std::int64_t, Body<float, 2>&, std::vector<std::int32_t>&);
template void dissolve_group(std::int64_t, Body<float, 3>&, std::vector<std::int32_t>&);
template double dissolve_group_gently(std::int64_t, Body<double, 2>&, std::vector<std::int32_t>&);
template double dissolve_group_gently(std::int64_t, Body<double, 3>&, std::vector<std::int32_t>&);
template double dissolve_group_gently(std::int64_t, Body<float, 2>&, std::vector<std::int32_t>&);
template double dissolve_group_gently(std::int64_t, Body<float, 3>&, std::vector<std::int32_t>&);

}  // namespace pliant::point_based
