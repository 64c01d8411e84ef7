#include "engine/point_based/bonds/candidates.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <optional>

namespace pliant::point_based {

template <int D>
std::vector<std::vector<typename NearestNodes<D>::Found>> find_candidates(
    const std::vector<Point<D>>& places, const std::vector<double>& elastic_volumes, int count,
    const std::string& body) {
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
  std::vector<std::vector<typename NearestNodes<D>::Found>> candidates(nodes);
  for (std::size_t node = 0; node < nodes; ++node) {
    const Point<D>& x = places[node];
    const bool is_elastic = elastic_volumes[node] > 0;
    auto found = is_elastic ? elastic_nodes.nearest(x, wanted) : all_nodes->nearest(x, wanted);
    for (auto& one : found) one.node = is_elastic ? number[one.node] : one.node;
    if (found.size() > 1 && found[1].distance == 0) {
      throw InputError(fmt::format("body `{}` has two nodes, {} and {}, at one place; remove one",
                                   body, found[0].node, found[1].node));
    }
    found.erase(found.begin());  // the node itself
    candidates[node] = std::move(found);
  }
  return candidates;
}

template std::vector<std::vector<NearestNodes<2>::Found>> find_candidates<2>(
    const std::vector<Point<2>>&, const std::vector<double>&, int, const std::string&);
template std::vector<std::vector<NearestNodes<3>::Found>> find_candidates<3>(
    const std::vector<Point<3>>&, const std::vector<double>&, int, const std::string&);

}  // namespace pliant::point_based
