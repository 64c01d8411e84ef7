#include "engine/blocks/numbering.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(numbering, blocks_follow_each_other_body_after_body) {
  std::vector<BlockOwner> owners;
  number_blocks(0, 2, owners);
  number_blocks(1, 0, owners);
  number_blocks(2, 3, owners);
  const std::vector<std::pair<int, int>> expected = {{0, 0}, {0, 1}, {2, 0}, {2, 1}, {2, 2}};
  ASSERT_EQ(owners.size(), expected.size());
  for (std::size_t b = 0; b < owners.size(); ++b) {
    EXPECT_EQ(std::pair(owners[b].body, owners[b].block), expected[b]);
  }
}

TEST(numbering, blocks_of_different_bodies_are_no_neighbours) {
  const std::vector<scheduler::Blocks> bodies = {{{{1}, {0}}}, {}, {{{}, {2}, {1}}}};
  EXPECT_EQ(join_blocks(bodies).neighbours,
            (std::vector<std::vector<int>>{{1}, {0}, {}, {4}, {3}}));
}

}  // namespace
}  // namespace pliant
