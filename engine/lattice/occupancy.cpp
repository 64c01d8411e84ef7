#include "engine/lattice/occupancy.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {

template <int D>
void Occupancy<D>::reset(Cell<D> lower, Cell<D> upper, int reach) {
  first_column_ = column_of(lower[0] - reach);
  columns_ = column_of(upper[0] + reach) + 1 - first_column_;
  for (int a = 1; a < D; ++a) {
    first_row_[a - 1] = lower[a] - reach;
    rows_[a - 1] = upper[a] + reach + 1 - first_row_[a - 1];
  }
  marked_.assign(static_cast<std::size_t>(rows()) * columns_, 0);
}

template <int D>
std::size_t Occupancy<D>::position(const Cell<D>& cell) const {
  return static_cast<std::size_t>(row_of(cell)) * columns_ + (column_of(cell[0]) - first_column_);
}

template <int D>
Cell<D> Occupancy<D>::row_cell(int row) const {
  Cell<D> cell = {};
  cell[1] = first_row_[0] + row % rows_[0];
  if constexpr (D == 3) cell[2] = first_row_[1] + row / rows_[0];
  return cell;
}

// Each marked row is widened step by step and added to all rows within reach: a row at the distance
// r gets the width of the ball there.
template <int D>
void Occupancy<D>::dilate(double radius) {
  const int reach = static_cast<int>(radius);
  dilated_.assign(marked_.size(), 0);
  for (int row = 0; row < rows(); ++row) {
    const auto begin = marked_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
    if (std::all_of(begin, begin + columns_, [](std::uint8_t cells) { return cells == 0; })) {
      continue;
    }
    widened_.assign(begin, begin + columns_);
    for (int along_x = 0; along_x <= reach; ++along_x) {
      if (along_x > 0) widen_by_one_cell();
      for (int dz = D == 3 ? -reach : 0; dz <= (D == 3 ? reach : 0); ++dz) {
        for (int dy = -reach; dy <= reach; ++dy) {
          const double chord2 = radius * radius - dy * dy - dz * dz;
          if (chord2 >= 0 && static_cast<int>(std::sqrt(chord2)) == along_x) add_to(row, dy, dz);
        }
      }
    }
  }
  marked_.swap(dilated_);
}

template <int D>
void Occupancy<D>::widen_by_one_cell() {
  std::uint8_t before = 0;
  for (int column = 0; column < columns_; ++column) {
    const std::uint8_t cells = widened_[column];
    const std::uint8_t after = column + 1 < columns_ ? widened_[column + 1] : 0;
    widened_[column] = static_cast<std::uint8_t>(cells | cells << 1 | cells >> 1 |
                                                 before >> (pack - 1) | after << (pack - 1));
    before = cells;
  }
}

// Ignores rows outside the map.
template <int D>
void Occupancy<D>::add_to(int row, int dy, int dz) {
  const int y = row % rows_[0] + dy, z = row / rows_[0] + dz;
  if (y < 0 || y >= rows_[0] || z < 0 || z >= rows_[1]) return;
  std::uint8_t* target = dilated_.data() + static_cast<std::size_t>(z * rows_[0] + y) * columns_;
  for (int column = 0; column < columns_; ++column) target[column] |= widened_[column];
}

template <int D>
void Occupancy<D>::fill_columns() {
  constexpr std::uint8_t whole_pack = 0xff;
  for (std::uint8_t& cells : marked_) {
    if (cells != 0) cells = whole_pack;
  }
}

template <int D>
std::vector<std::int32_t> Occupancy<D>::save() const {
  std::vector<std::int32_t> saved = {first_column_, columns_, first_row_[0],
                                     first_row_[1], rows_[0], rows_[1]};
  for (std::size_t i = 0; i < marked_.size(); ++i) {
    if (marked_[i]) saved.insert(saved.end(), {static_cast<std::int32_t>(i), marked_[i]});
  }
  return saved;
}

template <int D>
void Occupancy<D>::restore(const std::vector<std::int32_t>& saved) {
  first_column_ = saved.at(0);
  columns_ = saved.at(1);
  first_row_ = {saved.at(2), saved.at(3)};
  rows_ = {saved.at(4), saved.at(5)};
  marked_.assign(static_cast<std::size_t>(rows()) * columns_, 0);
  for (std::size_t i = 6; i + 1 < saved.size(); i += 2) {
    marked_.at(saved[i]) = static_cast<std::uint8_t>(saved[i + 1]);
  }
}

template class Occupancy<2>;
template class Occupancy<3>;

}  // namespace pliant
