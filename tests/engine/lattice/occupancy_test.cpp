#include "engine/lattice/occupancy.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/engine/lattice/random_cells.hpp"

namespace pliant::test {
namespace {

template <class Space>
struct Occupancies : testing::Test {};
TYPED_TEST_SUITE(Occupancies, Dimensions);

TYPED_TEST(Occupancies, a_mark_covers_the_pack_of_its_cell) {
  constexpr int D = TypeParam::dimension;
  Occupancy<D> map;
  map.reset(diagonal<D>(-20), diagonal<D>(20), 2);
  Cell<D> cell = diagonal<D>(-3);
  map.mark(cell);
  const std::vector<Cell<D>> cells = marked_cells(map);
  ASSERT_EQ(cells.size(), 8u);
  cell[0] = -8;  // packs begin at multiples of 8, below zero too
  for (const Cell<D>& marked : cells) {
    EXPECT_EQ(marked, cell);
    ++cell[0];
  }
}

TYPED_TEST(Occupancies, rows_are_found_again_from_their_cells_and_none_outside) {
  constexpr int D = TypeParam::dimension;
  Occupancy<D> map;
  map.reset(diagonal<D>(-4), diagonal<D>(5), 2);
  for (int row = 0; row < map.rows(); ++row) EXPECT_EQ(map.row_of(map.row_cell(row)), row);
  EXPECT_EQ(map.rows(), D == 2 ? 14 : 14 * 14);
  for (int axis = 1; axis < D; ++axis) {
    Cell<D> outside = diagonal<D>(0);
    outside[axis] = 8;
    EXPECT_EQ(map.row_of(outside), -1);
    outside[axis] = -7;
    EXPECT_EQ(map.row_of(outside), -1);
  }
}

// The oracle looks at every pair of packs.
TYPED_TEST(Occupancies, dilation_marks_the_packs_within_reach_of_a_mark_and_no_others) {
  constexpr int D = TypeParam::dimension;
  for (const int reach : {1, 3, 8, 9}) {
    Cell<D> lower = diagonal<D>(-9), upper = diagonal<D>(4);
    upper[0] = 50;
    Occupancy<D> before;
    before.reset(lower, upper, reach);
    const Occupancy<D> few = random_occupancy<D>(lower, upper, 0.003, reach);
    for (const Cell<D>& cell : marked_cells(few)) before.mark(cell);
    Occupancy<D> after = before;
    after.dilate(reach);

    const int pack_reach = (reach + 7) / 8;
    const auto within_reach = [&](int row, int column) {
      const Cell<D> cell = before.row_cell(row);
      for (const Cell<D>& mark : marked_cells(before)) {
        const int columns = std::abs(mark[0] - before.column_cell(column)) / 8;
        bool near = mark[0] % 8 == 0 && columns <= pack_reach;
        for (int a = 1; a < D; ++a) near = near && std::abs(mark[a] - cell[a]) <= reach;
        if (near) return true;
      }
      return false;
    };
    for (int row = 0; row < before.rows(); ++row) {
      for (int column = 0; column < before.columns(); ++column) {
        ASSERT_EQ(after.is_marked(row, column), within_reach(row, column))
            << "reach " << reach << ", row " << row << ", column " << column;
      }
    }
  }
}

TYPED_TEST(Occupancies, is_the_same_after_saving_and_restoring) {
  constexpr int D = TypeParam::dimension;
  const Occupancy<D> map = random_occupancy<D>(diagonal<D>(-13), diagonal<D>(6), 0.05, 1);
  Occupancy<D> restored;
  restored.reset(diagonal<D>(0), diagonal<D>(3), 1);
  restored.mark(diagonal<D>(2));
  restored.restore(map.save());
  EXPECT_EQ(restored.save(), map.save());
  EXPECT_EQ(marked_cells(restored), marked_cells(map));
  EXPECT_EQ(restored.row_of(diagonal<D>(-13)), map.row_of(diagonal<D>(-13)));
}

}  // namespace
}  // namespace pliant::test
