#include "engine/method/cached_graph.hpp"

#include <algorithm>
#include <iterator>

namespace pliant {

namespace {

// Blocks may approach each other by this many cells before the graph is built again.
constexpr int slack = 4;

void add_neighbours(scheduler::Blocks& blocks, const scheduler::Blocks& others) {
  for (int b = 0; b < blocks.count(); ++b) {
    std::vector<scheduler::BlockId> all;
    std::ranges::set_union(others.neighbours[b], blocks.neighbours[b], std::back_inserter(all));
    blocks.neighbours[b] = std::move(all);
  }
}

}  // namespace

template <int D>
bool CachedGraph<D>::has_counts(const Layouts<D>& layouts) const {
  return std::ranges::equal(block_counts_, layouts, {}, {},
                            [](const Layout<D>* layout) { return layout->blocks().size(); });
}

template <int D>
bool CachedGraph<D>::serves(const Layouts<D>& layouts) const {
  if (!graph_ || !has_counts(layouts)) return false;
  const auto& known = graph_->blocks().neighbours;
  int first = 0;
  for (const Layout<D>* layout : layouts) {
    for (std::size_t b = 0; b < layout->neighbours().size(); ++b) {
      for (const int near : layout->neighbours()[b]) {
        if (!std::ranges::binary_search(known[first + b], first + near)) return false;
      }
    }
    first += static_cast<int>(layout->neighbours().size());
  }
  return true;
}

// While the numbers of blocks stay the same, a new graph keeps the neighbours of the old one too.
// In an oscillating body, blocks approach and separate repeatedly, and a new graph at every
// remeshing would cost a small body a tenth of its time.
template <int D>
scheduler::StepGraph& CachedGraph<D>::over(const Layouts<D>& layouts,
                                           const MakePhases& make_phases) {
  if (serves(layouts)) return *graph_;
  scheduler::Blocks blocks = connect_blocks<D>(layouts, slack);
  if (graph_ && has_counts(layouts)) add_neighbours(blocks, graph_->blocks());
  const scheduler::ParallelGain gain = graph_ ? graph_->parallel_gain() : scheduler::ParallelGain();
  graph_ =
      std::make_unique<scheduler::StepGraph>(make_phases(), std::move(blocks), resource_names_);
  graph_->set_parallel_gain(gain);
  block_counts_.clear();
  for (const Layout<D>* layout : layouts) block_counts_.push_back(layout->blocks().size());
  return *graph_;
}

template class CachedGraph<2>;
template class CachedGraph<3>;

}  // namespace pliant
