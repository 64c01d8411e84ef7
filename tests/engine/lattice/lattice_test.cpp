#include "engine/lattice/lattice.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace pliant
