#include "engine/point_based/bonds.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/point_based/nearest_nodes.hpp"
#include "engine/point_based/node_operator.hpp"

namespace pliant::point_based {

namespace {

constexpr double support_over_distance = 1.05;  // of the nearest node that is no neighbour
constexpr int lanes = kernels::slots_per_pack;

/// [node] its slot.
template <class T, int D>
std::vector<std::int64_t> slots_of_nodes(const Body<T, D>& body) {
  std::vector<std::int64_t> slot(body.particles);
  for (std::int64_t s = 0; s < body.slots; ++s) {
    if (body.number[s] >= 0) slot[body.number[s]] = s;
  }
  return slot;
}

// A block's halo in ascending order: what it collects for one other block lies together.
template <class T, int D>
void find_halos(const Neighbours& neighbours, const std::vector<std::int64_t>& slot_of,
                Body<T, D>& body) {
  body.halo.clear();
  for (NodeBlock& block : body.blocks) {
    std::vector<std::int32_t> halo;
    for (int i = 0; i < block.nodes; ++i) {
      for (const std::int32_t node : neighbours.node[body.number[block.first + i]]) {
        const std::int64_t slot = slot_of[node];
        const bool is_own = slot >= block.first && slot < block.first + block.count;
        if (!is_own) halo.push_back(static_cast<std::int32_t>(slot));
      }
    }
    std::sort(halo.begin(), halo.end());
    halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
    block.first_halo = static_cast<std::int64_t>(body.halo.size());
    block.halo_count = static_cast<int>(halo.size());
    body.halo.insert(body.halo.end(), halo.begin(), halo.end());
  }
}

template <class T, int D>
std::uint16_t local_number(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot) {
  if (slot >= block.first && slot < block.first + block.count) {
    return static_cast<std::uint16_t>(slot - block.first);
  }
  const auto first = body.halo.begin() + block.first_halo;
  const auto at = std::lower_bound(first, first + block.halo_count, slot);
  return static_cast<std::uint16_t>(block.count + (at - first));
}

/// The bonds of one node.
template <class T, int D>
void make_bonds_of(const NodeBlock& block, std::int64_t slot, const Neighbours& neighbours,
                   const std::vector<std::int64_t>& slot_of, double alpha, Body<T, D>& body) {
  const std::int64_t node = body.number[slot];
  std::vector<Point<D>> bonds;
  std::vector<double> weights;
  for (const std::int32_t other : neighbours.node[node]) {
    Point<D> x;
    double square = 0;
    for (int a = 0; a < D; ++a) {
      x[a] = body.start[slot_of[other]][a] - body.start[slot][a];
      square += x[a] * x[a];
    }
    bonds.push_back(x);
    weights.push_back(bond_weight(std::sqrt(square) / neighbours.support[node]));
  }
  const NodeOperator<D> made = node_operator<D>(bonds, weights);
  const double modulus = body.material.lame_modulus + 2 * body.material.shear_modulus;
  body.stiffness[slot] = static_cast<T>(alpha * modulus / made.trace() * body.volume[slot]);
  for (int c = 0; c < Body<T, D>::symmetric; ++c) {
    body.moment[c][slot] = static_cast<T>(made.moment[c]);
  }
  const std::int64_t pack = slot / lanes, lane = slot % lanes;
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    const std::int64_t at = pack * body.bonds + static_cast<std::int64_t>(k);
    body.neighbour[at * lanes + lane] =
        local_number(body, block, slot_of[neighbours.node[node][k]]);
    T* const to = &body.bond[at * (D + 1) * lanes + lane];
    for (int a = 0; a < D; ++a) to[a * lanes] = static_cast<T>(made.gradient[k][a]);
    to[D * lanes] = static_cast<T>(weights[k]);
  }
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
Neighbours find_neighbours(const NodeCloud<D>& cloud, int count, double largest_support,
                           const std::string& body) {
  const NearestNodes<D> tree(cloud.positions);
  const auto nodes = static_cast<std::int32_t>(cloud.positions.size());
  if (nodes < 2) {
    throw InputError(
        fmt::format("body `{}` has {} node; use a finer discretisation.spacing, or a "
                    "cloud of more nodes",
                    body, nodes));
  }
  Neighbours neighbours;
  neighbours.node.resize(nodes);
  neighbours.support.resize(nodes);
  for (std::int32_t node = 0; node < nodes; ++node) {
    const auto found = tree.nearest(cloud.positions[node], static_cast<std::size_t>(count) + 2);
    if (found[1].distance == 0) {
      throw InputError(fmt::format("body `{}` has two nodes, {} and {}, at one place; remove one",
                                   body, found[0].node, found[1].node));
    }
    const auto last = std::min(found.size() - 1, static_cast<std::size_t>(count));
    const double support = std::min(support_over_distance * found.back().distance, largest_support);
    for (std::size_t k = 1; k <= last && found[k].distance < support; ++k) {
      neighbours.node[node].push_back(found[k].node);
    }
    neighbours.support[node] = support;
  }
  return neighbours;
}

template <class T, int D>
void make_bonds(const Neighbours& neighbours, double alpha, Body<T, D>& body) {
  std::size_t most = 0;
  for (const auto& list : neighbours.node) most = std::max(most, list.size());
  body.bonds = static_cast<int>(most);
  const std::vector<std::int64_t> slot_of = slots_of_nodes(body);
  find_halos(neighbours, slot_of, body);
  const auto points = body.slots + static_cast<std::int64_t>(body.halo.size());
  body.point.grow(points * kernels::point_stride, T(0));
  body.force.grow(points * kernels::point_stride, T(0));
  body.bond.grow(body.slots * body.bonds * (D + 1), T(0));
  body.neighbour.grow(body.slots * body.bonds, 0);
  for (const NodeBlock& block : body.blocks) {
    if (block.count + block.halo_count > std::numeric_limits<std::uint16_t>::max()) {
      throw InputError(
          fmt::format("the nodes of body `{}` are too uneven: a block of {} nodes has "
                      "{} neighbours",
                      body.name, block.nodes, block.halo_count));
    }
    for (int i = 0; i < block.count; ++i) {
      const std::int64_t slot = block.first + i;
      // Bonds of no weight lead back to the node itself.
      for (int k = 0; k < body.bonds; ++k) {
        body.neighbour[(slot / lanes * body.bonds + k) * lanes + slot % lanes] =
            static_cast<std::uint16_t>(i);
      }
      if (i < block.nodes) make_bonds_of(block, slot, neighbours, slot_of, alpha, body);
    }
  }
  connect_blocks(body);
}

template double lattice_support<2>(int);
template double lattice_support<3>(int);
template Neighbours find_neighbours<2>(const NodeCloud<2>&, int, double, const std::string&);
template Neighbours find_neighbours<3>(const NodeCloud<3>&, int, double, const std::string&);
template void make_bonds<double, 2>(const Neighbours&, double, Body<double, 2>&);
template void make_bonds<double, 3>(const Neighbours&, double, Body<double, 3>&);
template void make_bonds<float, 2>(const Neighbours&, double, Body<float, 2>&);
template void make_bonds<float, 3>(const Neighbours&, double, Body<float, 3>&);

}  // namespace pliant::point_based
