#include "engine/method/cached_graph.hpp"

#include <gtest/gtest.h>

namespace pliant::test {
namespace {

/// A layout with one block for each of the given rows of cells; blocks reach one cell.
Layout<2> blocks_at(const std::vector<std::int32_t>& rows) {
  constexpr int length = 512;
  Occupancy<2> occupancy;
  occupancy.reset({0, 0}, {length - 1, rows.back()}, 0);
  for (const std::int32_t y : rows) {
    for (std::int32_t x = 0; x < length; ++x) occupancy.mark({x, y});
  }
  Layout<2> layout;
  layout.build(occupancy, {}, static_cast<int>(rows.size()), 1);
  return layout;
}

struct CachedGraph : testing::Test {
  const scheduler::StepGraph& over(const std::vector<std::int32_t>& rows) {
    layout = blocks_at(rows);
    EXPECT_EQ(layout.blocks().size(), rows.size());
    return kept.over({&layout}, [this] {
      ++built;
      return std::vector<scheduler::Phase>{{.name = "nothing", .run = [](int) {}}};
    });
  }

  Layout<2> layout;
  pliant::CachedGraph<2> kept{{}};
  int built = 0;
};

TEST_F(CachedGraph, is_built_once_for_the_same_blocks) {
  over({0, 1});
  over({0, 1});
  EXPECT_EQ(built, 1);
}

TEST_F(CachedGraph, serves_blocks_that_part_or_come_a_little_nearer) {
  over({0, 5});
  over({0, 1});
  over({0, 80});
  EXPECT_EQ(built, 1);
}

TEST_F(CachedGraph, is_built_again_for_new_neighbours_and_keeps_the_old_ones) {
  over({0, 1, 40});
  const scheduler::StepGraph& graph = over({0, 39, 40});
  EXPECT_EQ(built, 2);
  EXPECT_EQ(graph.blocks().neighbours, (std::vector<std::vector<int>>{{1}, {0, 2}, {1}}));
  over({0, 1, 40});
  EXPECT_EQ(built, 2);
}

TEST_F(CachedGraph, is_built_anew_for_another_number_of_blocks) {
  over({0, 1, 40});
  const scheduler::StepGraph& graph = over({0, 40});
  EXPECT_EQ(built, 2);
  EXPECT_EQ(graph.blocks().neighbours, (std::vector<std::vector<int>>{{}, {}}));
}

TEST_F(CachedGraph, is_built_anew_once_it_was_dropped) {
  over({0, 1});
  kept.drop();
  over({0, 1});
  EXPECT_EQ(built, 2);
}

}  // namespace
}  // namespace pliant::test
