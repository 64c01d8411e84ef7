#include "engine/lattice/lattice.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pliant {
namespace {

TEST(lattice, a_node_lies_in_the_middle_of_its_cell) {
  const Lattice<2> lattice{0.25, {-1, 3}, {}};
  for (const std::int32_t c : {-7, -1, 0, 5}) {
    EXPECT_EQ(lattice.node(0, c), -1 + (c + 0.5) * 0.25);
    EXPECT_EQ(lattice.cell(1, lattice.node(1, c)), c);
    EXPECT_EQ(lattice.cell(1, lattice.node(1, c) + 0.12), c);
    EXPECT_EQ(lattice.cell(1, lattice.node(1, c) - 0.13), c - 1);
  }
}

TEST(lattice, cells_wrap_into_the_first_period_where_there_is_one) {
  const Lattice<3> lattice{1, {}, {8, 0, 5}};
  EXPECT_EQ(lattice.wrapped({-1, -1, -1}), (Cell<3>{7, -1, 4}));
  EXPECT_EQ(lattice.wrapped({8, 8, 13}), (Cell<3>{0, 8, 3}));
  EXPECT_EQ(lattice.wrapped({-16, 0, 4}), (Cell<3>{0, 0, 4}));
  EXPECT_TRUE(lattice.is_wrapped({7, -100, 0}));
  EXPECT_FALSE(lattice.is_wrapped({8, 0, 0}));
}

TEST(lattice, cells_of_a_box_come_one_by_one_x_fastest) {
  std::vector<Cell<3>> cells;
  for_each_cell<3>({-1, 2, 5}, {0, 3, 5}, [&](const Cell<3>& cell) { cells.push_back(cell); });
  EXPECT_EQ(cells, (std::vector<Cell<3>>{{-1, 2, 5}, {0, 2, 5}, {-1, 3, 5}, {0, 3, 5}}));
}

TEST(lattice, a_box_that_ends_before_it_begins_has_no_cells) {
  for_each_cell<2>({0, 0}, {-1, 4}, [](const Cell<2>&) { FAIL(); });
  for_each_cell<2>({0, 5}, {3, 4}, [](const Cell<2>&) { FAIL(); });
}

}  // namespace
}  // namespace pliant
