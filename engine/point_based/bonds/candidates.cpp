#include "engine/point_based/bonds/candidates.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <optional>

namespace pliant::point_based {

template <int D>
void sort_by_size(std::size_t count, Candidates<D>& candidates) {
  std::vector<double> size;
  size.reserve(candidates.size());
  for (const auto& list : candidates) {
    size.push_back(list[std::min<std::size_t>(D, list.size()) - 1].distance);
  }
  for (std::size_t node = 0; node < candidates.size(); ++node) {
    auto& list = candidates[node];
    for (auto& one : list) one.distance *= 2 * size[node] / (size[node] + size[one.node]);
    std::sort(list.begin(), list.end());
    if (list.size() > count) list.resize(count);
  }
}

template <int D>
Candidates<D> find_candidates(const std::vector<Point<D>>& places,
                              const std::vector<double>& elastic_volumes, int count,
                              const std::string& body, scheduler::Workers& workers) {
  const std::size_t nodes = places.size();
  if (nodes < 2) {
    throw InputError(
        fmt::format("body `{}` has {} node; use a finer discretisation.spacing, or a "
                    "cloud of more nodes",
                    body, nodes));
  }
  std::vector<Point<D>> elastic;
  std::vector<std::int32_t> number;  // numbers of the elastic nodes
  for (std::size_t node = 0; node < nodes; ++node) {
    if (elastic_volumes[node] == 0) continue;
    number.push_back(static_cast<std::int32_t>(node));
    elastic.push_back(places[node]);
  }
  const NearestNodes<D> elastic_nodes(elastic);
  std::optional<NearestNodes<D>> all_nodes;
  if (elastic.size() < nodes) all_nodes.emplace(places);
  const std::size_t wanted = static_cast<std::size_t>(count) + 1;
  Candidates<D> candidates(nodes);
  const auto search = [&](std::size_t node) {
    const Point<D>& x = places[node];
    const bool is_elastic = elastic_volumes[node] > 0;
    auto found = is_elastic ? elastic_nodes.nearest(x, wanted) : all_nodes->nearest(x, wanted);
    for (auto& one : found) one.node = is_elastic ? number[one.node] : one.node;
    candidates[node] = std::move(found);
  };
  constexpr std::size_t nodes_of_task = 1024;
  workers.for_each(static_cast<int>((nodes + nodes_of_task - 1) / nodes_of_task), [&](int task) {
    const std::size_t first = nodes_of_task * static_cast<std::size_t>(task);
    for (std::size_t n = first; n < std::min(first + nodes_of_task, nodes); ++n) search(n);
  });
  for (auto& found : candidates) {
    if (found.size() > 1 && found[1].distance == 0) {
      throw InputError(fmt::format("body `{}` has two nodes, {} and {}, at one place; remove one",
                                   body, found[0].node, found[1].node));
    }
    found.erase(found.begin());  // the node itself
  }
  return candidates;
}

template Candidates<2> find_candidates<2>(const std::vector<Point<2>>&, const std::vector<double>&,
                                          int, const std::string&, scheduler::Workers&);
template Candidates<3> find_candidates<3>(const std::vector<Point<3>>&, const std::vector<double>&,
                                          int, const std::string&, scheduler::Workers&);

template void sort_by_size<2>(std::size_t, Candidates<2>&);
template void sort_by_size<3>(std::size_t, Candidates<3>&);

}  // namespace pliant::point_based
