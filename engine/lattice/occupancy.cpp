#include "engine/lattice/occupancy.hpp"

#include <algorithm>

namespace pliant {

namespace {

std::int32_t column_of(std::int32_t x) {
  return x >= 0 ? x / Occupancy<2>::pack : -((-x + Occupancy<2>::pack - 1) / Occupancy<2>::pack);
}

}  // namespace

template <int D>
void Occupancy<D>::reset(Cell<D> lower, Cell<D> upper, int reach) {
  first_column_ = column_of(lower[0] - reach) - 1;
  columns_ = column_of(upper[0] + reach) + 2 - first_column_;
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

// Dilates along one direction: elements `stride` apart form lines of `line_length`.
template <int D>
void Occupancy<D>::dilate_rows(int stride, int lines, int line_length, int reach) {
  dilated_.assign(marked_.size(), 0);
  for (int line = 0; line < lines; ++line) {
    const std::size_t first =
        static_cast<std::size_t>(line / stride) * stride * line_length + line % stride;
    int until = -1;  // marks reach up to here
    for (int i = 0; i < line_length + reach; ++i) {
      if (i < line_length && marked_[first + static_cast<std::size_t>(i) * stride])
        until = i + reach;
      const int target = i - reach;
      if (target >= 0 && until >= target) {
        dilated_[first + static_cast<std::size_t>(target) * stride] = 1;
      }
    }
  }
  marked_.swap(dilated_);
}

template <int D>
void Occupancy<D>::dilate(int reach) {
  const int total = rows() * columns_;
  dilate_rows(1, rows(), columns_, (reach + pack - 1) / pack);
  dilate_rows(columns_, total / rows_[0], rows_[0], reach);
  if constexpr (D == 3) dilate_rows(columns_ * rows_[0], total / rows_[1], rows_[1], reach);
}

template <int D>
std::vector<std::int32_t> Occupancy<D>::save() const {
  std::vector<std::int32_t> saved = {first_column_, columns_, first_row_[0],
                                     first_row_[1], rows_[0], rows_[1]};
  for (std::size_t i = 0; i < marked_.size(); ++i) {
    if (marked_[i]) saved.push_back(static_cast<std::int32_t>(i));
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
  for (std::size_t i = 6; i < saved.size(); ++i) marked_.at(saved[i]) = 1;
}

template class Occupancy<2>;
template class Occupancy<3>;

}  // namespace pliant
