#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/lattice/layout_blocks.hpp"
#include "scheduler/step_graph.hpp"

namespace pliant {

/// A step graph that is built on first use, and again only when two blocks become neighbours that
/// the graph does not know as such, or when the number of blocks of a body changes. Pairs that are
/// no longer neighbours do no harm: they only restrict the order of nodes.
template <int D>
class CachedGraph {
 public:
  /// Names of the resources that its phases read and write.
  explicit CachedGraph(std::vector<std::string> resource_names)
      : resource_names_(std::move(resource_names)) {}

  using MakePhases = std::function<std::vector<scheduler::Phase>()>;

  /// The graph of the phases over the blocks of `layouts`.
  scheduler::StepGraph& over(const Layouts<D>& layouts, const MakePhases& make_phases);
  /// Discards the graph; needed when the phases change.
  void drop() { graph_.reset(); }

 private:
  bool has_counts(const Layouts<D>& layouts) const;
  bool serves(const Layouts<D>& layouts) const;

  std::vector<std::string> resource_names_;
  std::unique_ptr<scheduler::StepGraph> graph_;
  std::vector<std::size_t> block_counts_;  ///< [body] at the time the graph was built
};

extern template class CachedGraph<2>;
extern template class CachedGraph<3>;

}  // namespace pliant
