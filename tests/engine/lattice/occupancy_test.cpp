#include "engine/lattice/occupancy.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "tests/engine/lattice/random_cells.hpp"

namespace pliant::test {
namespace {

template <class Space>
struct Occupancies : testing::Test {};
TYPED_TEST_SUITE(Occupancies, Dimensions);

/// First cell and number of slots of each run of a row.
using Runs = std::vector<std::pair<std::int32_t, std::int32_t>>;

template <int D>
Runs runs_of(const std::vector<std::int32_t>& marks) {
  Occupancy<D> map;
  Cell<D> lower = {}, upper = {};
  lower[0] = -20;
  upper[0] = 100;
  map.reset(lower, upper, 0);
  for (const std::int32_t x : marks) {
    Cell<D> cell = {};
    cell[0] = x;
    map.mark(cell);
  }
  Runs runs;
  map.for_each_run(0,
                   [&](std::int32_t cell, std::int32_t count) { runs.emplace_back(cell, count); });
  return runs;
}

TYPED_TEST(Occupancies, runs_hold_whole_packs_with_the_marked_cells_in_their_middle) {
  constexpr int D = TypeParam::dimension;
  EXPECT_EQ(runs_of<D>({}), Runs());
  EXPECT_EQ(runs_of<D>({-3}), (Runs{{-6, 8}}));
  EXPECT_EQ(runs_of<D>({-3, 4}), (Runs{{-3, 8}}));
  EXPECT_EQ(runs_of<D>({-3, 5}), (Runs{{-6, 16}}));
}

// After rounding up, runs must be as far apart as a pack of a neighbouring row and its neighbours.
TYPED_TEST(Occupancies, gaps_that_a_pack_and_its_neighbours_bridge_are_stored) {
  constexpr int D = TypeParam::dimension;
  for (const std::int32_t begin : {-8, -3, 0, 5}) {
    EXPECT_EQ(runs_of<D>({begin, begin + 21}).size(), 1u);
    const Runs apart = runs_of<D>({begin, begin + 22});
    ASSERT_EQ(apart.size(), 2u);
    EXPECT_GE(apart[1].first - (apart[0].first + apart[0].second), 8 + 2 * kernels::row_reach);
  }
}

TYPED_TEST(Occupancies, a_mark_covers_its_cell_alone) {
  constexpr int D = TypeParam::dimension;
  Occupancy<D> map;
  map.reset(diagonal<D>(-20), diagonal<D>(20), 2);
  map.mark(diagonal<D>(-3));
  EXPECT_EQ(marked_cells(map), std::vector<Cell<D>>{diagonal<D>(-3)});
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

// The reference looks at every pair of a cell and a mark.
TYPED_TEST(Occupancies, dilation_marks_the_cells_within_a_ball_and_no_others) {
  constexpr int D = TypeParam::dimension;
  for (const double radius : {1.0, 1.8, 3.0, 6.0, 8.5}) {
    Cell<D> lower = diagonal<D>(-9), upper = diagonal<D>(4);
    upper[0] = 50;
    Occupancy<D> map;
    map.reset(lower, upper, 9);
    std::vector<Cell<D>> marks;
    std::mt19937 random(9);
    std::bernoulli_distribution chosen(D == 2 ? 0.005 : 0.001);
    for_each_cell<D>(lower, upper, [&](const Cell<D>& cell) {
      if (!chosen(random)) return;
      map.mark(cell);
      marks.push_back(cell);
    });
    ASSERT_FALSE(marks.empty());
    map.dilate(radius);
    const auto is_near = [&](const Cell<D>& cell) {
      for (const Cell<D>& mark : marks) {
        double square = 0;
        for (int a = 0; a < D; ++a) square += (mark[a] - cell[a]) * (mark[a] - cell[a]);
        if (square <= radius * radius) return true;
      }
      return false;
    };
    for (int row = 0; row < map.rows(); ++row) {
      for (int column = 0; column < map.columns(); ++column) {
        Cell<D> cell = map.row_cell(row);
        for (int i = 0; i < Occupancy<D>::pack; ++i) {
          cell[0] = map.column_cell(column) + i;
          ASSERT_EQ(map.is_marked(row, column, i), is_near(cell))
              << "radius " << radius << ", row " << row << ", cell " << cell[0];
        }
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
