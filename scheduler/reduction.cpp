#include <algorithm>
#include <numeric>
#include <utility>

#include "scheduler/dependencies.hpp"

// An edge u -> v is implied when another predecessor of v can be traced back to u. The level of a
// node, the length of the longest path that leads to it, rises along every path: the trace stays
// above u's level, and most edges join adjacent levels and need none. The usual detour runs through
// u's own block, so that going that way first finds it in a few hops.
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

class Tracer {
 public:
  Tracer(const std::vector<Node>& nodes, const std::vector<Edge>& edges)
      : nodes_(nodes),
        first_(nodes.size() + 1),
        level_(nodes.size()),
        last_trace_(nodes.size(), -1) {
    // Predecessors without repetition; edges come sorted by `to`, then `from`.
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (e > 0 && edges[e].has_ends_of(edges[e - 1])) continue;
      const auto to = static_cast<std::size_t>(edges[e].to);
      predecessors_.push_back(edges[e].from);
      ++first_[to + 1];
      level_[to] = std::max(level_[to], level(edges[e].from) + 1);
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  bool is_implied(const Edge& edge) {
    if (level(edge.from) + 1 == level(edge.to)) return false;
    ++trace_;
    pending_.clear();
    visit_predecessors(edge.to, edge.from);
    while (!pending_.empty()) {
      const int node = pending_.back();
      pending_.pop_back();
      if (visit_predecessors(node, edge.from)) return true;
    }
    return false;
  }

 private:
  // Stacks the predecessors through which a path from `target` may lead, the one in its block on
  // top; true when `target` is among the predecessors.
  bool visit_predecessors(int node, int target) {
    const auto n = static_cast<std::size_t>(node);
    const std::size_t bottom = pending_.size();
    bool leads_to_target = false;
    for (std::size_t i = first_[n]; i < first_[n + 1]; ++i) {
      const int before = predecessors_[i];
      leads_to_target |= before == target;
      if (level(before) <= level(target) || last_trace(before) == trace_) continue;
      last_trace(before) = trace_;
      pending_.push_back(before);
      const std::size_t top = pending_.size() - 1;
      if (top > bottom && block(pending_[top - 1]) == block(target))
        std::swap(pending_[top - 1], pending_[top]);
    }
    return leads_to_target;
  }

  BlockId block(int node) const { return nodes_[static_cast<std::size_t>(node)].block; }
  int level(int node) const { return level_[static_cast<std::size_t>(node)]; }
  int& last_trace(int node) { return last_trace_[static_cast<std::size_t>(node)]; }

  const std::vector<Node>& nodes_;
  std::vector<std::size_t> first_;  // [node] of its predecessors
  std::vector<int> predecessors_;
  std::vector<int> level_;
  std::vector<int> last_trace_;  // [node] that came by
  std::vector<int> pending_;
  int trace_ = 0;
};

// Leaves out every edge whose ends are joined by a longer path too.
std::vector<Edge> without_implied_edges(const std::vector<Node>& nodes,
                                        const std::vector<Edge>& edges) {
  Tracer tracer(nodes, edges);
  std::vector<Edge> kept;
  kept.reserve(edges.size());
  bool is_implied = false;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e == 0 || !edges[e].has_ends_of(edges[e - 1])) is_implied = tracer.is_implied(edges[e]);
    if (!is_implied) kept.push_back(edges[e]);
  }
  return kept;
}

}  // namespace

Dependencies reduced(const Dependencies& all) {
  auto result = without_idle_junctions(all);
  result.edges = without_implied_edges(result.nodes, result.edges);
  return result;
}

}  // namespace pliant::scheduler
