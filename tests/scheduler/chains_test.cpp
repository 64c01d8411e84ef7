#include "scheduler/chains.hpp"

#include <gtest/gtest.h>

#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

std::vector<int> heads_of(const std::vector<Phase>& phases, int blocks) {
  return chain_heads(derive_dependencies(phases, row_of_blocks(blocks), {"a", "b"}));
}

}  // namespace

TEST(chains, phases_that_stay_in_their_block_run_in_one_go) {
  const auto heads = heads_of({per_block("first", {}, {{0}}), per_block("second", {{0}}, {{1}}),
                               per_block("third", {{1}}, {})},
                              2);
  EXPECT_EQ(heads, (std::vector<int>{0, 1, 0, 1, 0, 1}));
}

TEST(chains, end_where_a_node_waits_for_several) {
  const auto heads = heads_of(
      {per_block("first", {}, {{0}}), per_block("second", {{0, Reach::neighbours}}, {})}, 2);
  EXPECT_EQ(heads, (std::vector<int>{0, 1, 2, 3}));
}

TEST(chains, do_not_hold_back_blocks_that_could_start) {
  const auto heads =
      heads_of({reduce("set", {}, {{0, Reach::all}}), per_block("use", {{0}}, {})}, 3);
  EXPECT_EQ(heads, (std::vector<int>{0, 1, 2, 3}));
}

TEST(chains, a_deeper_successor_waits_anyway) {
  // Block 0: first leads to second (alone) and, with second of block 1, to third of both blocks.
  const auto heads = heads_of({per_block("first", {}, {{0}}), per_block("second", {{0}}, {{1}}),
                               per_block("third", {{1, Reach::neighbours}}, {})},
                              2);
  EXPECT_EQ(heads, (std::vector<int>{0, 1, 0, 1, 4, 5}));
}

}  // namespace pliant::scheduler
