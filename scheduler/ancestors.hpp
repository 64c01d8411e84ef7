#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pliant::scheduler {

/// The ancestors of each node of a graph, as one bit for every earlier node. Nodes must be added in
/// an order in which all edges lead forwards, so that the ancestors of all predecessors are known.
class Ancestors {
 public:
  /// Adds the next node with its incoming edges, those of `edges` from `first` on. Removes each
  /// edge u -> v where u is an ancestor of another predecessor of v, unless `stays(edge)`. `Edge`
  /// has the node `from` that it leaves.
  template <class Edge, class Stays>
  void add_node(std::vector<Edge>& edges, std::size_t first, const Stays& stays) {
    const std::size_t node = begin_.size();
    begin_.push_back(words_.size());
    words_.resize(words_.size() + node / bits + 1);
    for (std::size_t e = first; e < edges.size(); ++e) {
      if (e == first || edges[e].from != edges[e - 1].from) inherit(edges[e].from);
    }
    const auto is_implied = [&](const Edge& edge) { return has(edge.from) && !stays(edge); };
    edges.erase(
        std::remove_if(edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end(), is_implied),
        edges.end());
    for (std::size_t e = first; e < edges.size(); ++e) add(edges[e].from);
  }

 private:
  static constexpr int bits = 64;

  // A word of the last node.
  std::uint64_t& word(int ancestor) {
    return words_[begin_.back() + static_cast<std::size_t>(ancestor / bits)];
  }
  bool has(int ancestor) { return (word(ancestor) >> (ancestor % bits) & 1u) != 0; }
  void add(int ancestor) { word(ancestor) |= std::uint64_t{1} << (ancestor % bits); }

  void inherit(int predecessor) {
    const auto p = static_cast<std::size_t>(predecessor);
    for (std::size_t w = 0; w < p / bits + 1; ++w)
      words_[begin_.back() + w] |= words_[begin_[p] + w];
  }

  std::vector<std::size_t> begin_;  // [node] begin of its words
  std::vector<std::uint64_t> words_;
};

}  // namespace pliant::scheduler
