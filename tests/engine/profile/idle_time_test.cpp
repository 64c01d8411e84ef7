#include "engine/profile/idle_time.hpp"

#include <gtest/gtest.h>

namespace pliant::test {
namespace {

using namespace scheduler;

/// `first` on two blocks, then `second`, which reads what both have written.
StepGraph two_then_one() {
  const auto nothing = [](BlockId) {};
  return {{{.name = "first", .writes = {{0}}, .run = nothing},
           {.name = "second",
            .reads = {{0, Reach::all}},
            .writes = {{1}},
            .kind = Phase::Kind::reduce,
            .run = nothing}},
          {{{1}, {0}}},
          {"a", "b"}};
}

void set_times(StepGraph& graph, int phase, BlockId block, const Span& span) {
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) {
    const Node& node = graph.nodes()[n];
    if (node.phase == phase && node.block == block) graph.record().spans[n] = span;
  }
}

//  time      0   1   2   3   4   5   6   7   8
//  worker 0  s   first 0......   w   w   w   s     w: waiting, s: scheduling
//  worker 1  first 1.  w   w   s   second.   s
TEST(idle_time, is_waiting_until_the_next_node_is_ready_and_scheduling_from_then_on) {
  StepGraph graph = two_then_one();
  set_times(graph, 0, 0, {1, 4, 0});
  set_times(graph, 0, 1, {0, 2, 1});
  set_times(graph, 1, 0, {5, 7, 1});
  graph.record().wall_seconds = 8;
  graph.record().worker_busy_seconds = {3, 4};
  profile::IdleTimeSplitter splitter;
  splitter.add(graph);
  const profile::IdleTime once = splitter.take();
  EXPECT_EQ(once.waiting, 3 + 2);
  EXPECT_EQ(once.scheduling, 2 + 2);
  EXPECT_EQ(once.waiting + once.scheduling, 2 * 8 - 3 - 4);
  splitter.add(graph);
  splitter.add(graph);
  EXPECT_EQ(splitter.take().waiting, 2 * once.waiting);
  EXPECT_EQ(splitter.take().scheduling, 0);
}

TEST(idle_time, of_a_worker_without_work_is_waiting_for_the_others) {
  StepGraph graph = two_then_one();
  set_times(graph, 0, 0, {0, 1, 0});
  set_times(graph, 0, 1, {1, 2, 0});
  set_times(graph, 1, 0, {2, 3, 0});
  graph.record().wall_seconds = 3;
  graph.record().worker_busy_seconds = {3, 0};
  profile::IdleTimeSplitter splitter;
  splitter.add(graph);
  const profile::IdleTime idle = splitter.take();
  EXPECT_EQ(idle.waiting, 3);
  EXPECT_EQ(idle.scheduling, 0);
}

}  // namespace
}  // namespace pliant::test
