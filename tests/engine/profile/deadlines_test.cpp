#include "engine/profile/deadlines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace pliant::test {
namespace {

using namespace profile;

TEST(percentiles, are_values_that_occurred_by_the_nearest_rank) {
  std::vector<double> values(100);
  std::iota(values.rbegin(), values.rend(), 1.);  // 100 ... 1
  EXPECT_EQ(percentile_of(values, 50), 50);
  EXPECT_EQ(percentile_of(values, 95), 95);
  EXPECT_EQ(percentile_of(values, 99), 99);
  EXPECT_EQ(percentile_of(values, 99.9), 100);
  EXPECT_EQ(percentile_of(values, 100), 100);
  EXPECT_EQ(percentile_of({3}, 1), 3);
  EXPECT_TRUE(std::isnan(percentile_of({}, 50)));
}

TEST(percentiles, leave_so_many_frames_to_miss) {
  EXPECT_EQ(most_missed(100, 99), 1);
  EXPECT_EQ(most_missed(600, 99), 6);
  EXPECT_EQ(most_missed(600, 100), 0);
  EXPECT_EQ(most_missed(50, 99), 0);
}

/// Frames with a phase `calm` of one second and a phase `wild` for the rest.
Profile profile_of(const std::vector<double>& seconds, double budget, double percentile) {
  Profile profile;
  profile.options.budget = budget;
  profile.options.percentile = percentile;
  profile.options.frame_seconds = 1;
  profile.phases = {"calm", "wild"};
  for (const double time : seconds) {
    FrameRecord frame;
    frame.wall_seconds = time;
    frame.phase_seconds = {1, time - 1};
    profile.frames.push_back(frame);
    profile.steps.push_back({0, time});
  }
  return profile;
}

TEST(verdict, counts_missed_deadlines_and_the_longest_row_of_them) {
  const Verdict verdict = judge(profile_of({2, 5, 5, 2, 5, 5, 5, 2, 2, 2}, 3, 50));
  EXPECT_EQ(verdict.missed, 5);
  EXPECT_EQ(verdict.longest_streak, 3);
  EXPECT_TRUE(verdict.held);  // by the median
  EXPECT_DOUBLE_EQ(verdict.real_time_factor, 10 / 35.);
  EXPECT_FALSE(judge(profile_of({2, 5, 5, 2, 5, 5, 5, 2, 2, 2}, 3, 60)).held);
}

TEST(verdict, lists_the_ten_longest_frames_the_longest_first) {
  const Verdict verdict = judge(profile_of({2, 3, 9, 4, 5, 2, 2, 2, 6, 2, 2, 2, 2, 8}, 3, 99));
  ASSERT_EQ(verdict.worst.size(), 10u);
  EXPECT_EQ(std::vector<std::size_t>(verdict.worst.begin(), verdict.worst.begin() + 6),
            (std::vector<std::size_t>{2, 13, 8, 4, 3, 1}));
}

TEST(verdict, blames_the_part_that_grew_most_in_the_worst_frames_not_the_largest) {
  std::vector<double> seconds(100, 1.5);
  for (std::size_t i = 0; i < 100; i += 10) seconds[i] = 4;
  const Verdict verdict = judge(profile_of(seconds, 2, 99));
  EXPECT_EQ(verdict.parts[0].name, "calm");
  EXPECT_DOUBLE_EQ(verdict.parts[0].share, 100 / 175.);
  const Part& blamed = verdict.parts[verdict.to_blame];
  EXPECT_EQ(blamed.name, "wild");
  EXPECT_DOUBLE_EQ(blamed.excess(), 2.5);
}

}  // namespace
}  // namespace pliant::test
