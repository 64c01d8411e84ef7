#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "engine/lattice/occupancy.hpp"

namespace pliant::test {

/// A dimension as a type, for typed tests.
template <int D>
struct Plane {
  static constexpr int dimension = D;
};
using Dimensions = testing::Types<Plane<2>, Plane<3>>;

/// Calls `f` for every cell of the box lower..upper (inclusive).
template <int D, class F>
void for_each_cell(const Cell<D>& lower, const Cell<D>& upper, F&& f) {
  Cell<D> cell = lower;
  for (int a = 0; a < D;) {
    f(cell);
    for (a = 0; a < D && ++cell[a] > upper[a]; ++a) cell[a] = lower[a];
  }
}

/// A cell with the same coordinate in every direction.
template <int D>
Cell<D> diagonal(std::int32_t x) {
  Cell<D> cell;
  cell.fill(x);
  return cell;
}

/// A map over lower..upper with random marked cells: rows of every kind, with gaps of all lengths
/// and empty rows between them.
template <int D>
Occupancy<D> random_occupancy(const Cell<D>& lower, const Cell<D>& upper, double share, int seed) {
  Occupancy<D> occupancy;
  occupancy.reset(lower, upper, 3);
  std::mt19937 random(seed);
  std::bernoulli_distribution chosen(share);
  for_each_cell<D>(lower, upper, [&](const Cell<D>& cell) {
    if (chosen(random)) occupancy.mark(cell);
  });
  return occupancy;
}

template <int D>
std::vector<Cell<D>> marked_cells(const Occupancy<D>& occupancy) {
  std::vector<Cell<D>> cells;
  for (int row = 0; row < occupancy.rows(); ++row) {
    for (int column = 0; column < occupancy.columns(); ++column) {
      Cell<D> cell = occupancy.row_cell(row);
      for (int i = 0; i < Occupancy<D>::pack; ++i) {
        if (!occupancy.is_marked(row, column, i)) continue;
        cell[0] = occupancy.column_cell(column) + i;
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

}  // namespace pliant::test
