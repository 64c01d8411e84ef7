#pragma once

#include <string>
#include <vector>

#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "scheduler/workers.hpp"

namespace pliant::point_based {

/// How many of the `count` nearest nodes are neighbours. Of nodes at equal distances either all or
/// none are, so that rounding does not decide. `distance(n)` is that of the n-th node, `next` that
/// of the first one after them. Returns `count` where fewer than `least` would remain.
template <class F>
std::size_t whole_shells(std::size_t count, double next, std::size_t least, F&& distance) {
  constexpr double equally_far = 1e-6;
  std::size_t whole = count;
  while (whole > 0 && distance(whole - 1) >= (1 - equally_far) * next) --whole;
  return whole < least ? count : whole;
}

/// [node] nodes that may become its neighbours, by distance.
template <int D>
using Candidates = std::vector<std::vector<typename NearestNodes<D>::Found>>;

/// The `count` nearest nodes of each place in `places`, or all others if there are fewer. The
/// candidates of a node with an elastic volume must have one too, (PB.21). Throws InputError that
/// names `body` if two nodes are at one place or the cloud has only one node.
template <int D>
Candidates<D> find_candidates(const std::vector<Point<D>>& places,
                              const std::vector<double>& elastic_volumes, int count,
                              const std::string& body, scheduler::Workers& workers);

/// Keeps the `count` candidates with the smallest ratio of the distance to the mean of the sizes of
/// both nodes, (PB.2). By distance alone, a node next to smaller ones would have hardly any
/// neighbour of its own size.
template <int D>
void sort_by_size(std::size_t count, Candidates<D>& candidates);

}  // namespace pliant::point_based
