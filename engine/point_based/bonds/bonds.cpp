#include "engine/point_based/bonds/bonds.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/method/hyperelastic.hpp"
#include "engine/point_based/bonds/candidates.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/bonds/node_frequency.hpp"
#include "engine/point_based/bonds/node_operator.hpp"

namespace pliant::point_based {

namespace {

constexpr double support_over_distance = 1.05;  // of the nearest node that is not a neighbour
constexpr double joint_factor_beside_cuts = 1.2;
constexpr int lanes = kernels::slots_per_pack;

// Finds the halos of all blocks, in ascending order, so that what a block collects for another
// block is contiguous. `for_each_neighbour(slot, f)` calls f(slot) for all possible neighbours of a
// node.
template <class T, int D, class F>
void find_halos(Body<T, D>& body, F&& for_each_neighbour) {
  body.halo.clear();
  body.most_points = 0;
  for (NodeBlock& block : body.blocks) {
    std::vector<std::int32_t> halo;
    for (int i = 0; i < block.nodes; ++i) {
      for_each_neighbour(block.first + i, [&](std::int64_t slot) {
        const bool is_own = slot >= block.first && slot < block.first + block.count;
        if (!is_own) halo.push_back(static_cast<std::int32_t>(slot));
      });
    }
    std::sort(halo.begin(), halo.end());
    halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
    block.first_halo = static_cast<std::int64_t>(body.halo.size());
    block.halo_count = static_cast<int>(halo.size());
    body.halo.insert(body.halo.end(), halo.begin(), halo.end());
    const int points = block.count + block.halo_count;
    body.most_points = std::max(body.most_points, points);
    constexpr int addressable = std::numeric_limits<std::uint16_t>::max() / kernels::point_stride;
    if (points > addressable) {
      throw InputError(
          fmt::format("the nodes of body `{}` are too uneven: a block of {} nodes has "
                      "{} neighbours",
                      body.name, block.nodes, block.halo_count));
    }
  }
}

// The halos must be known.
template <class T, int D>
void make_room_for_bonds(int bonds, Body<T, D>& body) {
  body.bonds = bonds;
  const auto points = body.slots + static_cast<std::int64_t>(body.halo.size());
  body.force.grow(points * kernels::point_stride, T(0));
  body.bond.grow(body.slots * body.bonds * (D + 1), T(0));
  body.neighbour.grow(body.slots * body.bonds, 0);
  body.degenerate.assign(body.blocks.size(), {});
}

/// Neighbours of a node, and their weights.
struct Chosen {
  std::vector<std::int64_t> slot;
  std::vector<double> weight;
};

template <int D>
Chosen choose(const BondChoice<D>& choice, std::span<const double> factors, std::int64_t node) {
  const auto& candidates = choice.candidates[node];
  const auto factor = [&](std::size_t k) { return factors.empty() ? 1 : factors[k]; };
  std::vector<std::size_t> taken;
  double next = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (factor(k) == 0) continue;
    next = candidates[k].distance;
    if (static_cast<int>(taken.size()) == choice.neighbours) {
      taken.resize(whole_shells(taken.size(), next, D + 1,
                                [&](std::size_t n) { return candidates[taken[n]].distance; }));
      break;
    }
    taken.push_back(k);
  }
  const double support = choice.is_lattice() ? choice.support : support_over_distance * next;
  Chosen chosen;
  for (const std::size_t k : taken) {
    if (candidates[k].distance >= support) continue;
    chosen.slot.push_back(choice.slot_of[candidates[k].node]);
    chosen.weight.push_back(choice.correction_of(node, k) * factor(k) *
                            bond_weight(candidates[k].distance / support));
  }
  return chosen;
}

/// Adds a node to the list of degenerate ones, or removes it.
template <class T, int D>
void set_rank(const NodeOperator<D>& made, int block, std::int64_t slot, double volume,
              Body<T, D>& body) {
  std::erase_if(body.degenerate[block],
                [slot](const DegenerateNode<D>& node) { return node.slot == slot; });
  body.volume[slot] = made.rank == D ? static_cast<T>(volume) : T(0);
  if (made.rank < D) body.degenerate[block].push_back({slot, made.rank, made.direction, volume});
}

/// lambda_i of (PB.12) from the bonds of a node, with its whole volume.
template <class T, int D>
double frequency2_of(const Chosen& chosen, const NodeOperator<D>& made, std::int64_t slot,
                     double volume, const Body<T, D>& body) {
  std::vector<BondStiffness<D>> bonds;
  bonds.reserve(chosen.slot.size());
  for (std::size_t k = 0; k < chosen.slot.size(); ++k) {
    bonds.push_back({made.gradient[k], chosen.weight[k], body.mass[chosen.slot[k]]});
  }
  return node_frequency2<D>({body.material.lame_modulus, body.material.shear_modulus, volume,
                             body.stiffness[slot], body.mass[slot]},
                            bonds);
}

template <class T, int D>
void connect_blocks(Body<T, D>& body) {
  const auto block_of = [&](std::int64_t slot) {
    return static_cast<int>(&body.block_of(slot) - body.blocks.data());
  };
  body.collected.assign(body.blocks.size(), {});
  auto& near = body.adjacency.neighbours;
  near.assign(body.blocks.size(), {});
  for (int b = 0; b < static_cast<int>(body.blocks.size()); ++b) {
    const NodeBlock& block = body.blocks[b];
    const std::int32_t* const halo = body.halo.data() + block.first_halo;
    for (int begin = 0; begin < block.halo_count;) {
      const int owner = block_of(halo[begin]);
      int end = begin + 1;
      while (end < block.halo_count && block_of(halo[end]) == owner) ++end;
      const T* const force =
          &body.force[kernels::point_stride * (block.first_point() + block.count + begin)];
      body.collected[owner].push_back({force, halo + begin, end - begin});
      near[b].push_back(owner);
      near[owner].push_back(b);
      begin = end;
    }
  }
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

template <class T, int D>
void write_bonds(const NodeBlock& block, std::int64_t slot, const GivenBonds<D>& bonds,
                 std::span<const double> weights, Body<T, D>& body) {
  const std::int64_t pack = slot / lanes, lane = slot % lanes;
  for (int k = 0; k < body.bonds; ++k) {
    const std::int64_t at = pack * body.bonds + k;
    // Bonds of zero weight point to the node itself.
    const bool exists = k < static_cast<int>(bonds.slot.size());
    const std::int64_t number = body.local_number(block, exists ? bonds.slot[k] : slot);
    body.neighbour[at * lanes + lane] = static_cast<std::uint16_t>(kernels::point_stride * number);
    T* const to = &body.bond[at * (D + 1) * lanes + lane];
    for (int a = 0; a < D; ++a)
      to[a * lanes] = exists ? static_cast<T>(bonds.gradient[k][a]) : T(0);
    to[D * lanes] = exists ? static_cast<T>(weights[k]) : T(0);
  }
}

}  // namespace

template <int D>
double lattice_support(int count) {
  std::vector<double> distance;
  constexpr int reach = 4;
  Cell<D> first, last;
  first.fill(-reach);
  last.fill(reach);
  for_each_cell<D>(first, last, [&](const Cell<D>& cell) {
    double square = 0;
    for (const double x : cell) square += x * x;
    distance.push_back(std::sqrt(square));
  });
  std::nth_element(distance.begin(), distance.begin() + count + 1, distance.end());
  return support_over_distance * distance[count + 1];
}

template <int D>
std::vector<double> weights_of(const BondChoice<D>& choice, std::int64_t node) {
  return choose(choice, {}, node).weight;
}

template <class T, int D>
void set_bonds(const BondChoice<D>& choice, std::span<const double> factors, std::int64_t slot,
               Body<T, D>& body) {
  const NodeBlock& block = body.block_of(slot);
  const Chosen chosen = choose(choice, factors, body.number[slot]);
  std::vector<Point<D>> bonds;
  bonds.reserve(chosen.slot.size());
  for (const std::int64_t other : chosen.slot) {
    Point<D>& x = bonds.emplace_back();
    for (int a = 0; a < D; ++a) x[a] = body.start[other][a] - body.start[slot][a];
  }
  const NodeOperator<D> made = node_operator<D>(bonds, chosen.weight);
  const double volume = choice.elastic_volumes[body.number[slot]];
  set_rank(made, static_cast<int>(&block - body.blocks.data()), slot, volume, body);
  const double mu = long_term_share(body.prony_shear) * body.material.shear_modulus;
  const double lambda = body.material.lame_modulus;
  const double modulus = std::min(lambda, stiff_lame_over_shear * mu) + 2 * mu;
  body.stiffness[slot] =
      made.rank == D ? static_cast<T>(choice.alpha * modulus / made.trace() * volume) : T(0);
  for (int c = 0; c < Body<T, D>::symmetric; ++c) {
    body.moment[c][slot] = static_cast<T>(made.moment[c]);
  }
  const bool is_cut = std::ranges::any_of(factors, [](double factor) { return factor < 1; });
  const double joint_frequency_factor =
      choice.joint_frequency_factor * (is_cut ? joint_factor_beside_cuts : 1);
  body.frequency2[slot] =
      static_cast<T>(joint_frequency_factor * frequency2_of(chosen, made, slot, volume, body));
  write_bonds<T, D>(block, slot, {chosen.slot, made.gradient}, chosen.weight, body);
}

template <class T, int D>
void make_bonds(const BondChoice<D>& choice, Body<T, D>& body) {
  std::size_t most = 0;
  for (const auto& list : choice.candidates) most = std::max(most, list.size());
  find_halos(body, [&](std::int64_t slot, auto&& f) {
    const auto& candidates = choice.candidates[body.number[slot]];
    const std::size_t count = choice.may_change
                                  ? candidates.size()
                                  : std::min<std::size_t>(candidates.size(), choice.neighbours);
    for (std::size_t k = 0; k < count; ++k) f(choice.slot_of[candidates[k].node]);
  });
  make_room_for_bonds(std::min(static_cast<int>(most), choice.neighbours), body);
  for (const NodeBlock& block : body.blocks) {
    for (int i = 0; i < block.nodes; ++i) set_bonds<T, D>(choice, {}, block.first + i, body);
  }
  connect_blocks(body);
}

template <class T, int D>
void make_bonds(const std::vector<GivenBonds<D>>& bonds, Body<T, D>& body) {
  std::size_t most = 0;
  for (const GivenBonds<D>& of_node : bonds) most = std::max(most, of_node.slot.size());
  find_halos(body, [&](std::int64_t slot, auto&& f) {
    for (const std::int64_t neighbour : bonds[slot].slot) f(neighbour);
  });
  make_room_for_bonds(static_cast<int>(most), body);
  const std::vector<double> weights(most, 1);
  for (const NodeBlock& block : body.blocks) {
    for (int i = 0; i < block.nodes; ++i) {
      write_bonds<T, D>(block, block.first + i, bonds[block.first + i], weights, body);
    }
  }
  connect_blocks(body);
}

template double lattice_support<2>(int);
template double lattice_support<3>(int);
template std::vector<double> weights_of(const BondChoice<2>&, std::int64_t);
template std::vector<double> weights_of(const BondChoice<3>&, std::int64_t);
template void make_bonds(const BondChoice<2>&, Body<double, 2>&);
template void make_bonds(const std::vector<GivenBonds<2>>&, Body<double, 2>&);
template void set_bonds(const BondChoice<2>&, std::span<const double>, std::int64_t,
                        Body<double, 2>&);
template void make_bonds(const BondChoice<3>&, Body<double, 3>&);
template void make_bonds(const std::vector<GivenBonds<3>>&, Body<double, 3>&);
template void set_bonds(const BondChoice<3>&, std::span<const double>, std::int64_t,
                        Body<double, 3>&);
template void make_bonds(const BondChoice<2>&, Body<float, 2>&);
template void make_bonds(const std::vector<GivenBonds<2>>&, Body<float, 2>&);
template void set_bonds(const BondChoice<2>&, std::span<const double>, std::int64_t,
                        Body<float, 2>&);
template void make_bonds(const BondChoice<3>&, Body<float, 3>&);
template void make_bonds(const std::vector<GivenBonds<3>>&, Body<float, 3>&);
template void set_bonds(const BondChoice<3>&, std::span<const double>, std::int64_t,
                        Body<float, 3>&);

}  // namespace pliant::point_based
