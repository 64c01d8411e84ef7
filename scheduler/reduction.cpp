#include <algorithm>
#include <numeric>

#include "scheduler/ancestors.hpp"
#include "scheduler/dependencies.hpp"

namespace pliant::scheduler {

namespace {

constexpr int dropped = -1;

// Removes junctions that save no edges, and joins their ends directly.
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
      // No junction leads to another one: they replace readers, and only writers have readers.
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

// Removes every edge whose ends are also joined by a longer path. Edges must be sorted by `to`.
std::vector<Edge> without_implied_edges(std::size_t nodes, const std::vector<Edge>& edges) {
  Ancestors ancestors;
  std::vector<Edge> kept;
  auto next = edges.begin();
  for (std::size_t node = 0; node < nodes; ++node) {
    const std::size_t first = kept.size();
    for (; next != edges.end() && static_cast<std::size_t>(next->to) == node; ++next) {
      kept.push_back(*next);
    }
    ancestors.add_node(kept, first, [](const Edge&) { return false; });
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
