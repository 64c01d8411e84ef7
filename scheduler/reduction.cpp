#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "scheduler/dependencies.hpp"

// An edge u -> v is implied when u is an ancestor of another predecessor of v. Edges only lead from
// lower to higher nodes: the ancestors of all predecessors are known when a node's turn comes.
namespace pliant::scheduler {

namespace {

constexpr int dropped = -1;

// Drops the junctions that save no edges, joining their ends directly.
Dependencies without_idle_junctions(const Dependencies& all) {
  const std::size_t count = all.nodes.size();
  std::vector<int> in(count), out(count), first_edge(count), position(count);
  for (const Edge& edge : all.edges) {
    ++in[static_cast<std::size_t>(edge.to)];
    ++out[static_cast<std::size_t>(edge.from)];
  }
  std::exclusive_scan(in.begin(), in.end(), first_edge.begin(), 0);
  Dependencies kept;
  for (std::size_t n = 0; n < count; ++n) {
    const bool is_idle = all.nodes[n].is_junction() && in[n] * out[n] <= in[n] + out[n];
    position[n] = is_idle ? dropped : static_cast<int>(kept.nodes.size());
    if (!is_idle) kept.nodes.push_back(all.nodes[n]);
  }
  for (std::size_t n = 0; n < count; ++n) {
    const int to = position[n];
    if (to == dropped) continue;
    const std::size_t first = kept.edges.size();
    for (int e = first_edge[n]; e < first_edge[n] + in[n]; ++e) {
      const Edge& edge = all.edges[static_cast<std::size_t>(e)];
      const auto from = static_cast<std::size_t>(edge.from);
      if (position[from] != dropped) {
        kept.edges.push_back({position[from], to, edge.field});
        continue;
      }
      // No junction leads to another: junctions stand for readers, and only writers have readers.
      for (int before = first_edge[from]; before < first_edge[from] + in[from]; ++before) {
        const auto origin =
            static_cast<std::size_t>(all.edges[static_cast<std::size_t>(before)].from);
        kept.edges.push_back({position[origin], to, edge.field});
      }
    }
    const auto begin = kept.edges.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, kept.edges.end());
    kept.edges.erase(std::unique(begin, kept.edges.end()), kept.edges.end());
  }
  return kept;
}

// The ancestors of every node, one bit for each node before it.
class Ancestors {
 public:
  explicit Ancestors(std::size_t nodes) : first_word_(nodes + 1) {
    for (std::size_t n = 0; n < nodes; ++n) first_word_[n + 1] = first_word_[n] + n / bits + 1;
    words_.resize(first_word_.back());
  }

  bool has(int node, int ancestor) const {
    return (words_[word_of(node, ancestor)] >> (ancestor % bits) & 1u) != 0;
  }

  void add(int node, int ancestor) {
    words_[word_of(node, ancestor)] |= std::uint64_t{1} << (ancestor % bits);
  }

  void add_those_of(int other, int node) {
    const std::size_t from = first_word(other), to = first_word(node);
    const std::size_t count = first_word(other + 1) - from;
    for (std::size_t w = 0; w < count; ++w) words_[to + w] |= words_[from + w];
  }

 private:
  static constexpr int bits = 64;

  std::size_t first_word(int node) const { return first_word_[static_cast<std::size_t>(node)]; }
  std::size_t word_of(int node, int ancestor) const {
    return first_word(node) + static_cast<std::size_t>(ancestor / bits);
  }

  std::vector<std::size_t> first_word_;  // [node]
  std::vector<std::uint64_t> words_;
};

// Leaves out every edge whose ends are joined by a longer path too. Edges come sorted by `to`.
std::vector<Edge> without_implied_edges(std::size_t nodes, const std::vector<Edge>& edges) {
  Ancestors ancestors(nodes);
  std::vector<Edge> kept;
  kept.reserve(edges.size());
  for (auto begin = edges.begin(); begin != edges.end();) {
    const int node = begin->to;
    const auto end =
        std::find_if(begin, edges.end(), [&](const Edge& edge) { return edge.to != node; });
    for (auto e = begin; e != end; ++e) ancestors.add_those_of(e->from, node);
    std::copy_if(begin, end, std::back_inserter(kept),
                 [&](const Edge& edge) { return !ancestors.has(node, edge.from); });
    for (auto e = begin; e != end; ++e) ancestors.add(node, e->from);
    begin = end;
  }
  return kept;
}

}  // namespace

Dependencies reduced(const Dependencies& all) {
  auto result = without_idle_junctions(all);
  result.edges = without_implied_edges(result.nodes.size(), result.edges);
  return result;
}

}  // namespace pliant::scheduler
