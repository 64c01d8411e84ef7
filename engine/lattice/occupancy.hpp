#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"
#include "kernels/layout.hpp"

namespace pliant {

/// The lattice cells that a body needs: a map of marked cells over rows (y, or y and z) and columns
/// with as many cells as a pack has slots.
///
/// A row stores runs of whole packs. They begin near its first marked cell, not at a column, which
/// leaves half as many slots vacant. The free slots of a run are divided between its two ends.
///
///     marked       . . . o o o o o o o o o o o o o . . . .
///     stored      [. . o o o o o o|o o o o o o o .]           packs of 8 slots
template <int D>
class Occupancy {
 public:
  /// Cells in a pack.
  static constexpr int pack = kernels::slots_per_pack;

  /// Clears all marks and covers the cells lower..upper (inclusive) and `reach` cells around them.
  void reset(Cell<D> lower, Cell<D> upper, int reach);

  void mark(const Cell<D>& cell) {
    const int lane = cell[0] - column_cell(column_of(cell[0]) - first_column_);
    marked_[position(cell)] |= static_cast<std::uint8_t>(1 << lane);
  }

  /// Marks every cell of the map within `radius` cells of a marked one.
  void dilate(double radius);
  /// Marks all cells of columns that have a mark, so that runs begin at columns.
  void fill_columns();

  /// The marked cells as plain numbers, for checkpoints.
  std::vector<std::int32_t> save() const;
  void restore(const std::vector<std::int32_t>& saved);

  int rows() const { return rows_[0] * rows_[1]; }
  int columns() const { return columns_; }
  /// Row number of (y[, z]) and back; x is not part of it.
  Cell<D> row_cell(int row) const;
  std::int32_t column_cell(int column) const { return (first_column_ + column) * pack; }
  bool is_marked(int row, int column, int lane) const {
    return (marks(row, column) >> lane & 1) != 0;
  }

  /// Calls `f(cell, count)` for every run of a row: `count` slots, in whole packs, for the cells
  /// from `cell` on along x.
  template <class F>
  void for_each_run(int row, F&& f) const {
    std::int32_t begin = 0, end = 0;
    const auto store = [&] {
      const std::int32_t count = (end - begin + pack - 1) / pack * pack;
      f(begin - (count - (end - begin)) / 2, count);
    };
    for (int column = 0; column < columns_; ++column) {
      const std::uint8_t cells = marks(row, column);
      if (cells == 0) continue;
      const std::int32_t first = column_cell(column) + std::countr_zero(cells);
      if (begin == end || first - end >= shortest_gap) {
        if (begin != end) store();
        begin = first;
      }
      end = column_cell(column) + pack - std::countl_zero(cells);
    }
    if (begin != end) store();
  }

  /// Slots of all runs.
  std::int64_t slots() const {
    std::int64_t sum = 0;
    for (int row = 0; row < rows(); ++row) {
      for_each_run(row, [&sum](std::int32_t, std::int32_t count) { sum += count; });
    }
    return sum;
  }
  /// Row number of a cell, or -1 outside the map.
  int row_of(const Cell<D>& cell) const {
    int row = 0;
    for (int a = D - 1; a >= 1; --a) {
      const int r = cell[a] - first_row_[a - 1];
      if (r < 0 || r >= rows_[a - 1]) return -1;
      row = row * rows_[a - 1] + r;
    }
    return row;
  }

 private:
  /// Smallest number of cells without marks between two runs; shorter gaps are stored. After runs
  /// are rounded up to whole packs, no pack of a neighbouring row is near both of them.
  static constexpr std::int32_t shortest_gap = (pack - 1) + (pack + 2 * kernels::row_reach);

  std::uint8_t marks(int row, int column) const {
    return marked_[static_cast<std::size_t>(row) * columns_ + column];
  }
  static std::int32_t column_of(std::int32_t x) {
    return x >= 0 ? x / pack : -((-x + pack - 1) / pack);
  }
  std::size_t position(const Cell<D>& cell) const;
  void widen_by_one_cell();
  void add_to(int row, int dy, int dz);

  std::int32_t first_column_ = 0;
  int columns_ = 0;
  std::array<std::int32_t, 2> first_row_ = {};
  std::array<int, 2> rows_ = {1, 1};
  std::vector<std::uint8_t> marked_, dilated_;  ///< [row][column], one bit for each cell
  std::vector<std::uint8_t> widened_;           ///< [column] of one row
};

extern template class Occupancy<2>;
extern template class Occupancy<3>;

}  // namespace pliant
