#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"
#include "engine/lattice/occupancy.hpp"
#include "kernels/layout.hpp"

namespace pliant {

/// A contiguous run of segments: the unit of a task.
template <int D>
struct Block {
  int first_segment = 0, segment_count = 0;
  std::int64_t first_slot = 0, slot_count = 0;
  Cell<D> lower = {}, upper = {};  ///< inclusive, in cells
};

/// Where the slots of a body are in memory.
///
/// Only cells near marked ones have slots. Those of a lattice row form runs, see Occupancy. Runs
/// follow each other row by row (in 3D in tiles of rows, so that close slots stay close in memory).
/// Segments divide a run where a neighbouring row changes its run. `padding` slots before the first
/// and after the last run make every load of a segment's neighbours legal. What is next to the ends
/// of a run belongs to other rows.
template <int D>
class Layout {
 public:
  static constexpr std::int64_t padding = 1024;
  static constexpr int pack = Occupancy<D>::pack;

  /// Builds the runs of the map and divides them into `block_count` blocks of about the same size
  /// (fewer if segments are longer than that). Blocks are neighbours if they are within
  /// `block_reach` cells of each other.
  void build(const Occupancy<D>& occupancy, const Cell<D>& period, int block_count,
             int block_reach);

  const Occupancy<D>& occupancy() const { return occupancy_; }
  std::int64_t slots() const { return slots_; }  ///< including padding
  const std::vector<kernels::Segment<D>>& segments() const { return segments_; }
  const std::vector<Block<D>>& blocks() const { return blocks_; }
  const std::vector<std::vector<int>>& neighbours() const { return neighbours_; }
  /// The same for blocks that are up to `more` cells farther away.
  std::vector<std::vector<int>> neighbours_and(int more) const {
    std::vector<std::vector<int>> neighbours;
    connect_blocks(block_reach_ + more, neighbours);
    return neighbours;
  }

  const kernels::Segment<D>* segments_of(const Block<D>& block) const {
    return segments_.data() + block.first_segment;
  }

  /// Slot of a cell, or -1 if it has none.
  std::int64_t slot(const Cell<D>& cell) const { return slot(cell, 1); }

  /// Slot of the first of `count` cells along x, or -1 unless all are in one run.
  std::int64_t slot(const Cell<D>& cell, int count) const {
    const int row = occupancy_.row_of(cell);
    if (row < 0) return -1;
    for (int r = row_begin_[row]; r < row_begin_[row + 1]; ++r) {
      const Run& run = runs_[r];
      if (cell[0] >= run.cell && cell[0] + count <= run.cell + run.count) {
        return run.first + (cell[0] - run.cell);
      }
    }
    return -1;
  }

  /// Calls `f(x, slot, n)` for each contiguous range of slots among the `count` cells from `cell`
  /// on along x: slots slot..slot+n-1 of the cells x..x+n-1.
  template <class F>
  void for_each_stretch(const Cell<D>& cell, int count, F&& f) const {
    const int row = occupancy_.row_of(cell);
    if (row < 0) return;
    for (int r = row_begin_[row]; r < row_begin_[row + 1]; ++r) {
      const Run& run = runs_[r];
      const std::int32_t x = std::max(cell[0], run.cell);
      const std::int32_t n = std::min(cell[0] + count, run.cell + run.count) - x;
      if (n > 0) f(x, run.first + (x - run.cell), n);
    }
  }

  /// Cell of a slot that belongs to a segment.
  Cell<D> cell(std::int64_t slot) const;

  /// Calls `f(slot, cell)` for every slot of a block, in slot order.
  template <class F>
  void for_each_slot(const Block<D>& block, F&& f) const {
    for (int s = block.first_segment; s < block.first_segment + block.segment_count; ++s) {
      const kernels::Segment<D>& segment = segments_[s];
      Cell<D> cell = segment.cell;
      for (int i = 0; i < segment.count; ++i, ++cell[0]) f(segment.first + i, cell);
    }
  }

 private:
  struct Run {
    std::int64_t first;  ///< slot of the first pack
    std::int32_t cell;   ///< x cell of that slot
    std::int32_t count;  ///< slots
  };

  void find_runs();
  void place_runs();
  void cut_segments();
  void cut_run(const Run& run, Cell<D> row);
  void group_blocks(int block_count);
  void connect_blocks(int reach, std::vector<std::vector<int>>& neighbours) const;
  const Run* run_near(int row, std::int32_t lower, std::int32_t upper) const;

  Occupancy<D> occupancy_;
  Cell<D> period_ = {};
  int block_reach_ = 0;
  std::int64_t slots_ = 2 * padding;
  std::vector<Run> runs_;       ///< by row number
  std::vector<int> row_begin_;  ///< [row + 1] into runs_
  std::vector<int> row_order_;  ///< rows in storage order
  std::vector<kernels::Segment<D>> segments_;
  std::vector<Block<D>> blocks_;
  std::vector<std::vector<int>> neighbours_;
};

extern template class Layout<2>;
extern template class Layout<3>;

}  // namespace pliant
