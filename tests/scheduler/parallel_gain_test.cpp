#include "scheduler/parallel_gain.hpp"

#include <gtest/gtest.h>

namespace pliant::scheduler {

namespace {

/// The share of runs on all workers of a graph that takes that long [s].
double share_on_all_workers(ParallelGain& gain, double alone, double together, int runs = 500) {
  int on_all = 0;
  for (int run = 0; run < runs; ++run) {
    const bool is_parallel = gain.is_expected();
    on_all += is_parallel;
    gain.record(is_parallel ? together : alone);
  }
  return static_cast<double>(on_all) / runs;
}

}  // namespace

TEST(parallel_gain, a_short_graph_stays_on_the_calling_thread_unless_others_make_it_faster) {
  ParallelGain gain;
  EXPECT_LT(share_on_all_workers(gain, 100e-6, 120e-6), 0.02);
  gain = {};
  EXPECT_LT(share_on_all_workers(gain, 100e-6, 90e-6), 0.02) << "not worth the other cores";
  gain = {};
  EXPECT_GT(share_on_all_workers(gain, 400e-6, 250e-6), 0.99);
}

TEST(parallel_gain, a_long_graph_goes_on_all_workers_after_one_run) {
  ParallelGain gain;
  EXPECT_FALSE(gain.is_expected());
  gain.record(5e-3);
  EXPECT_TRUE(gain.is_expected());
  EXPECT_GT(share_on_all_workers(gain, 5e-3, 6e-3), 0.99) << "its chains suit the caches";
}

TEST(parallel_gain, a_graph_that_becomes_longer_is_tried_again) {
  ParallelGain gain;
  share_on_all_workers(gain, 100e-6, 120e-6, 100'000);
  EXPECT_GT(share_on_all_workers(gain, 400e-6, 250e-6), 0.98);
}

TEST(parallel_gain, trials_become_rare) {
  ParallelGain gain;
  share_on_all_workers(gain, 400e-6, 250e-6, 10'000);
  EXPECT_GT(share_on_all_workers(gain, 400e-6, 250e-6, 40'000), 0.9995);
}

}  // namespace pliant::scheduler
