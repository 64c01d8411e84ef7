#pragma once

#include <string>
#include <vector>

#include "engine/point_based/bonds/nearest_nodes.hpp"

namespace pliant::point_based {

/// How many of the `count` nearest nodes are neighbours: of nodes that are equally far away all or
/// none are, whichever rounding puts first. `distance(n)` is that of the n-th, `next` that of the
/// one after the last, which is none; all `count` of them where fewer than `least` would remain.
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

/// The `count` nodes nearest to each of those at `places`, or all others where there are fewer; of
/// a node with an elastic volume, those with one too, (PB.21). Throws InputError, in the name of
/// `body`, for two nodes at one place and for a cloud of one node.
template <int D>
Candidates<D> find_candidates(const std::vector<Point<D>>& places,
                              const std::vector<double>& elastic_volumes, int count,
                              const std::string& body);

/// Of the candidates, the `count` nearest by the distance over the mean of the sizes of both nodes,
/// (PB.2): a node next to smaller ones would else have hardly any neighbour among those of its own
/// size.
template <int D>
void sort_by_size(std::size_t count, Candidates<D>& candidates);

}  // namespace pliant::point_based
