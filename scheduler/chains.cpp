#include "scheduler/chains.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pliant::scheduler {

std::vector<int> chain_heads(const Dependencies& dependencies) {
  constexpr int nobody = -1, several = -2, none = std::numeric_limits<int>::max();
  const auto& nodes = dependencies.nodes;
  std::vector<int> only_predecessor(nodes.size(), nobody), level(nodes.size(), 0);
  for (const Edge& edge : dependencies.edges) {
    const auto to = static_cast<std::size_t>(edge.to);
    auto& predecessor = only_predecessor[to];
    predecessor = predecessor == nobody || predecessor == edge.from ? edge.from : several;
    level[to] = std::max(level[to], level[static_cast<std::size_t>(edge.from)] + 1);
  }

  // The lowest level among the successors of each node, and how many are at it. A successor that is
  // alone there may join the chain.
  std::vector<int> lowest(nodes.size(), none), at_lowest(nodes.size(), 0);
  for (std::size_t e = 0; e < dependencies.edges.size(); ++e) {
    const Edge& edge = dependencies.edges[e];
    if (e > 0 && edge.has_ends_of(dependencies.edges[e - 1])) continue;
    const auto from = static_cast<std::size_t>(edge.from);
    const int next = level[static_cast<std::size_t>(edge.to)];
    if (next < lowest[from]) at_lowest[from] = 0;
    lowest[from] = std::min(lowest[from], next);
    if (next == lowest[from]) ++at_lowest[from];
  }

  std::vector<int> head(nodes.size());
  std::iota(head.begin(), head.end(), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (only_predecessor[n] < 0 || nodes[n].is_junction()) continue;
    const auto before = static_cast<std::size_t>(only_predecessor[n]);
    if (nodes[before].is_junction() || level[n] > lowest[before] || at_lowest[before] > 1) continue;
    head[n] = head[before];
  }
  return head;
}

}  // namespace pliant::scheduler
