#include "engine/lattice/layout_blocks.hpp"

#include <gtest/gtest.h>

namespace pliant::test {
namespace {

/// Slots for `cells` cells in a row, in up to `blocks` blocks whose reach is one cell.
Layout<2> row_of(int cells, int blocks) {
  Occupancy<2> occupancy;
  occupancy.reset({0, 0}, {cells - 1, 0}, 0);
  for (int x = 0; x < cells; ++x) occupancy.mark({x, 0});
  Layout<2> layout;
  layout.build(occupancy, {}, blocks, 1);
  return layout;
}

struct TwoBodies : testing::Test {
  Layout<2> one = row_of(8, 1), many = row_of(4096, 4);
  Layouts<2> layouts = {&one, &many};
};

TEST_F(TwoBodies, have_their_blocks_numbered_one_body_after_the_other) {
  ASSERT_GT(many.blocks().size(), 2u);
  std::vector<BlockOwner> owners = {{7, 7}};
  number_blocks<2>(layouts, owners);
  ASSERT_EQ(owners.size(), 1 + many.blocks().size());
  EXPECT_EQ(owners[0].body, 0);
  EXPECT_EQ(owners[0].block, 0);
  for (std::size_t b = 1; b < owners.size(); ++b) {
    EXPECT_EQ(owners[b].body, 1);
    EXPECT_EQ(owners[b].block, static_cast<int>(b) - 1);
  }
}

TEST_F(TwoBodies, have_neighbours_among_their_own_blocks_only) {
  const scheduler::Blocks blocks = connect_blocks<2>(layouts, 0);
  ASSERT_EQ(blocks.count(), 1 + static_cast<int>(many.blocks().size()));
  EXPECT_TRUE(blocks.neighbours[0].empty());
  EXPECT_EQ(blocks.neighbours[1], std::vector<int>{2});
  EXPECT_EQ(blocks.neighbours[2], (std::vector<int>{1, 3}));
}

TEST_F(TwoBodies, have_more_neighbours_where_blocks_may_be_farther_away) {
  const scheduler::Blocks blocks = connect_blocks<2>(layouts, 4096);
  EXPECT_TRUE(blocks.neighbours[0].empty());
  EXPECT_EQ(blocks.neighbours[1].size(), many.blocks().size() - 1);
}

}  // namespace
}  // namespace pliant::test
