#include <algorithm>
#include <numeric>
#include <utility>

#include "scheduler/reduction.hpp"

// The level of a node, the length of the longest path that leads to it, rises along every path: the
// trace stays above u's level, and most edges join adjacent levels and need none. The usual detour
// runs through u's own block, so that going that way first finds it in a few hops.
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

}  // namespace

void Reduction::add(const Node& node, std::vector<Edge>& edges, std::size_t first) {
  int level = 0;
  for (std::size_t e = first; e < edges.size(); ++e) {
    if (e > first && edges[e].has_ends_of(edges[e - 1])) continue;
    predecessors_.push_back(edges[e].from);
    level = std::max(level, level_[static_cast<std::size_t>(edges[e].from)] + 1);
  }
  nodes_.push_back(node);
  level_.push_back(level);
  last_trace_.push_back(-1);
  ends_.push_back(predecessors_.size());
  drop_implied(edges, first);
  predecessors_.resize(begin_of(nodes_.size() - 1));
  for (std::size_t e = first; e < edges.size(); ++e) {
    if (e == first || !edges[e].has_ends_of(edges[e - 1])) predecessors_.push_back(edges[e].from);
  }
  ends_.back() = predecessors_.size();
}

void Reduction::drop_implied(std::vector<Edge>& edges, std::size_t first) {
  std::size_t kept = first;
  bool implied = false;
  for (std::size_t e = first; e < edges.size(); ++e) {
    if (e == first || edges[e].from != last_from_) implied = is_implied(edges[e]);
    last_from_ = edges[e].from;
    if (!implied) edges[kept++] = edges[e];
  }
  edges.resize(kept);
}

bool Reduction::is_implied(const Edge& edge) {
  if (junctions_ == Junctions::kept && (is_junction(edge.from) || is_junction(edge.to))) {
    return false;
  }
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

// Stacks the predecessors through which a path from `target` may lead, the one in its block on
// top; true when `target` is among the predecessors.
bool Reduction::visit_predecessors(int node, int target) {
  const auto n = static_cast<std::size_t>(node);
  const std::size_t bottom = pending_.size();
  bool leads_to_target = false;
  for (std::size_t i = begin_of(n); i < ends_[n]; ++i) {
    const int before = predecessors_[i];
    leads_to_target |= before == target;
    if (level(before) <= level(target) || last_trace(before) == trace_) continue;
    if (junctions_ == Junctions::kept && is_junction(before)) continue;
    last_trace(before) = trace_;
    pending_.push_back(before);
    const std::size_t top = pending_.size() - 1;
    if (top > bottom && block(pending_[top - 1]) == block(target))
      std::swap(pending_[top - 1], pending_[top]);
  }
  return leads_to_target;
}

Dependencies reduced(const Dependencies& all) {
  const Dependencies before = without_idle_junctions(all);
  Dependencies result;
  result.nodes = before.nodes;
  Reduction reduction(Reduction::Junctions::traced);
  std::size_t e = 0;
  for (std::size_t n = 0; n < before.nodes.size(); ++n) {
    const std::size_t first = result.edges.size();
    for (; e < before.edges.size() && before.edges[e].to == static_cast<int>(n); ++e) {
      result.edges.push_back(before.edges[e]);
    }
    reduction.add(before.nodes[n], result.edges, first);
  }
  return result;
}

}  // namespace pliant::scheduler
