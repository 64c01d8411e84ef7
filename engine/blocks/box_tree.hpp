#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/blocks/box.hpp"

namespace pliant {

/// Boxes of ever longer runs of a list of boxes, for lists whose neighbours are also neighbours in
/// position. A search takes O(log n) steps plus one for each box found.
template <int D>
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box<D>> boxes) {
    levels_.push_back(std::move(boxes));
    while (levels_.back().size() > 1) {
      const std::vector<Box<D>>& below = levels_.back();
      std::vector<Box<D>> level((below.size() + 1) / 2);
      for (std::size_t i = 0; i < below.size(); ++i) level[i / 2].grow(below[i]);
      levels_.push_back(std::move(level));
    }
  }

  const Box<D>& operator[](std::size_t i) const { return levels_[0][i]; }

  /// Calls f(i) in ascending order for those boxes, from number `from` on, whose squared gap to
  /// `box` is at most `squared_radius`.
  template <class F>
  void for_each_near(const Box<D>& box, double squared_radius, std::size_t from, F&& f) const {
    if (!levels_[0].empty()) visit(levels_.size() - 1, 0, box, squared_radius, from, f);
  }

 private:
  template <class F>
  void visit(std::size_t level, std::size_t i, const Box<D>& box, double squared_radius,
             std::size_t from, F& f) const {
    if ((i + 1) << level <= from || i >= levels_[level].size()) return;
    if (squared_gap(levels_[level][i], box) > squared_radius) return;
    if (level == 0) {
      f(i);
      return;
    }
    visit(level - 1, 2 * i, box, squared_radius, from, f);
    visit(level - 1, 2 * i + 1, box, squared_radius, from, f);
  }

  std::vector<std::vector<Box<D>>> levels_;  ///< [level][i] box of runs of 2^level boxes
};

}  // namespace pliant
