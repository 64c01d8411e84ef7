#include "scheduler/step_record.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

#include "scheduler/step_graph.hpp"
#include "tests/scheduler/phases.hpp"

namespace pliant::scheduler {

namespace {

using namespace testing;

void spin_for(std::chrono::microseconds duration) {
  const auto end = std::chrono::steady_clock::now() + duration;
  while (std::chrono::steady_clock::now() < end) {
  }
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// "work" in two stages of 100 us in each of 4 blocks, with a fold of 50 us in between.
StepGraph timed_graph() {
  using namespace std::chrono_literals;
  auto work = per_block("work", {}, {{0}}, [](BlockId) { spin_for(100us); });
  auto fold = reduce("fold", {{0, Reach::all}}, {{0, Reach::all}}, [](BlockId) { spin_for(50us); });
  auto work_again = work;
  work.stage = 0;
  work_again.stage = 1;
  return {{work, fold, work_again}, row_of_blocks(4), {"a"}};
}

}  // namespace

TEST(step_record, stages_of_a_phase_share_a_timer) {
  StepGraph graph = timed_graph();
  EXPECT_EQ(graph.timer_names(), (std::vector<std::string>{"work", "fold"}));
  Workers workers(1);
  graph.run(workers);
  // Spinning never ends early; how late it ends depends on the machine.
  EXPECT_GE(graph.record().phase_seconds[0], 8 * 100e-6);
  EXPECT_GE(graph.record().phase_seconds[1], 50e-6);
  for (int b = 0; b < 4; ++b)
    EXPECT_GE(graph.record().block_seconds[static_cast<std::size_t>(b)], 2 * 100e-6);
}

TEST(step_record, phases_blocks_workers_and_spans_sum_to_the_same_time) {
  for (const int threads : {1, 2, 7}) {
    StepGraph graph = timed_graph();
    Workers workers(threads);
    graph.run(workers);
    const StepRecord& record = graph.record();
    const double total = sum(record.phase_seconds);
    // The same durations, summed in another order: equal except for rounding.
    const double rounding = 1e-12;
    EXPECT_NEAR(sum(record.block_seconds), total, rounding);
    EXPECT_NEAR(sum(record.worker_busy_seconds), total, rounding);
    double in_spans = 0;
    for (const Span& span : record.spans) in_spans += span.stop - span.start;
    EXPECT_NEAR(in_spans, total, rounding);
    ASSERT_EQ(record.worker_busy_seconds.size(), static_cast<std::size_t>(threads));
    for (const double busy : record.worker_busy_seconds) EXPECT_LE(busy, record.wall_seconds);
    EXPECT_GE(record.idle_share(), 0);
    EXPECT_LT(record.idle_share(), 1);
  }
}

TEST(step_record, a_step_begins_from_zero) {
  StepGraph graph = timed_graph();
  graph.run_serially(0);
  graph.run_serially(1);
  EXPECT_LE(sum(graph.record().phase_seconds), graph.record().wall_seconds);
}

TEST(step_totals, keep_their_sums_when_graphs_change) {
  const StepRecord first{.start = {},
                         .wall_seconds = 3,
                         .phase_seconds = {1, 2},
                         .block_seconds = {},
                         .worker_busy_seconds = {3},
                         .spans = {}};
  const StepRecord second{.start = {},
                          .wall_seconds = 4,
                          .phase_seconds = {10, 20},
                          .block_seconds = {},
                          .worker_busy_seconds = {1, 3},
                          .spans = {}};
  StepTotals totals;
  totals.add(first, std::vector<std::string>{"advance", "fold"});
  totals.add(second, std::vector<std::string>{"fold", "remesh"});
  EXPECT_EQ(totals.steps(), 2);
  EXPECT_EQ(totals.wall_seconds(), 7);
  ASSERT_EQ(totals.timers().size(), 3u);
  EXPECT_EQ(totals.timers()[0].name, "advance");
  EXPECT_EQ(totals.timers()[0].seconds, 1);
  EXPECT_EQ(totals.timers()[1].name, "fold");
  EXPECT_EQ(totals.timers()[1].seconds, 12);
  EXPECT_EQ(totals.timers()[2].name, "remesh");
  EXPECT_EQ(totals.timers()[2].seconds, 20);
  EXPECT_EQ(totals.worker_busy_seconds(), (std::vector<double>{4, 3}));
  EXPECT_EQ(totals.idle_share(), 1 - 7.0 / (2 * 7.0));
}

}  // namespace pliant::scheduler
