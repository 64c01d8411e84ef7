#include <gtest/gtest.h>

#include "scheduler/step_graph.hpp"
#include "tests/allocation_counter.hpp"
#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

TEST(allocation, a_warm_step_allocates_nothing) {
  using namespace testing;
  for (const int threads : {1, 2, 7}) {
    StepGraph graph(
        {per_block("advance", {{0, Reach::neighbours}}, {{1}}), per_block("copy", {{1}}, {{0}}),
         reduce("fold", {{0, Reach::all}}, {{2, Reach::all}}),
         per_block("gather", {{0, Reach::all}}, {{1}})},
        row_of_blocks(20), {"a", "b", "c"});
    Workers workers(threads);
    StepTotals totals;
    const auto step = [&] {
      graph.run(workers);
      totals.add(graph.record(), graph.timer_names());
    };
    for (int warm = 0; warm < 3; ++warm) step();
    const auto stretch = [&] {
      for (int i = 0; i < 20; ++i) step();
    };
    EXPECT_EQ(test::least_allocations(stretch), 0) << threads << " threads";
  }
}

}  // namespace pliant::scheduler
