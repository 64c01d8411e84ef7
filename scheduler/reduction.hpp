#pragma once

#include <cstddef>
#include <vector>

#include "scheduler/dependencies.hpp"

namespace pliant::scheduler {

/// Leaves out, node by node, the edges that others imply: an edge u -> v is implied when another
/// predecessor of v can be traced back to u. What is left out at one node is not looked at for the
/// next, so that no more than one node's edges are ever held in full.
class Reduction {
 public:
  /// Edges of junctions stay, and nothing is traced through them, as long as some may be removed.
  enum class Junctions { kept, traced };

  explicit Reduction(Junctions junctions) : junctions_(junctions) {}

  /// The next node, and the edges to it: those of `edges` from `first` on, sorted. Removes the
  /// implied ones.
  void add(const Node& node, std::vector<Edge>& edges, std::size_t first);

 private:
  void drop_implied(std::vector<Edge>& edges, std::size_t first);
  bool is_implied(const Edge& edge);
  bool visit_predecessors(int node, int target);
  std::size_t begin_of(std::size_t node) const { return node == 0 ? 0 : ends_[node - 1]; }
  bool is_junction(int node) const { return nodes_[static_cast<std::size_t>(node)].is_junction(); }
  BlockId block(int node) const { return nodes_[static_cast<std::size_t>(node)].block; }
  int level(int node) const { return level_[static_cast<std::size_t>(node)]; }
  int& last_trace(int node) { return last_trace_[static_cast<std::size_t>(node)]; }

  Junctions junctions_;
  std::vector<Node> nodes_;
  std::vector<int> predecessors_;  ///< without repetition
  std::vector<std::size_t> ends_;  ///< [node] of its predecessors
  std::vector<int> level_;
  std::vector<int> last_trace_;  ///< [node] that came by
  std::vector<int> pending_;
  int trace_ = 0, last_from_ = -1;
};

}  // namespace pliant::scheduler
