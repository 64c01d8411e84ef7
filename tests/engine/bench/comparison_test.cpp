#include "engine/bench/comparison.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <cmath>
#include <random>

namespace pliant::bench {
namespace {

/// Three repetitions on a machine with these figures.
Record record(double rate, double fma_peak, double triad) {
  RecordedRow row{"disc/compact/0.1/1", 314, 1, {}};
  for (const double noise : {0.97, 1.0, 1.02}) {
    row.samples.push_back({noise * rate, fma_peak, triad, 1e-7 / 3});
  }
  return {{"a machine"}, {row}};
}

Verdict verdict_of(const Record& before, const Record& after) {
  return changes(before, after, 0.1)[0].verdict;
}

TEST(comparison, a_slower_machine_is_no_regression) {
  const Record before = record(20e6, 40e9, 10e9);
  EXPECT_EQ(Verdict::same, verdict_of(before, record(10e6, 20e9, 5e9)));
  // Limited by multiply-adds, then by memory.
  EXPECT_EQ(Verdict::same, verdict_of(before, record(10e6, 20e9, 10e9)));
  EXPECT_EQ(Verdict::same, verdict_of(before, record(10e6, 40e9, 5e9)));
}

TEST(comparison, a_slower_program_is_a_regression_on_any_machine) {
  const Record before = record(20e6, 40e9, 10e9);
  EXPECT_EQ(Verdict::slower, verdict_of(before, record(17e6, 40e9, 10e9)));
  EXPECT_EQ(Verdict::slower, verdict_of(before, record(17e6, 80e9, 20e9)));
  EXPECT_EQ(Verdict::slower, verdict_of(before, record(8.5e6, 20e9, 5e9)));
  EXPECT_EQ(Verdict::faster, verdict_of(before, record(23e6, 40e9, 10e9)));
  EXPECT_EQ(Verdict::same, verdict_of(before, record(18.5e6, 40e9, 10e9)));
}

TEST(comparison, only_rows_that_both_records_have_are_compared) {
  Record other = record(1, 1, 1);
  other.rows[0].name = "ball/compact/0.1/1";
  EXPECT_TRUE(changes(other, record(1, 1, 1), 0.1).empty());
}

TEST(comparison, a_record_survives_its_file) {
  const Record written = record(20e6 / 3, 40e9 / 7, 1e10 / 9);
  const Record read = parse_record(json_of(written), "x");
  ASSERT_EQ(1u, read.rows.size());
  EXPECT_EQ(written.machine, read.machine);
  EXPECT_EQ(written.rows[0].name, read.rows[0].name);
  EXPECT_EQ(written.rows[0].samples[2].rate, read.rows[0].samples[2].rate);
  EXPECT_EQ(written.rows[0].samples[2].triad, read.rows[0].samples[2].triad);
  EXPECT_EQ(written.rows[0].samples[2].hand_over, read.rows[0].samples[2].hand_over);
  for (const char* text : {"", "{}", "[1]", R"({"format": "pliant bench 0"})"}) {
    EXPECT_THROW(parse_record(text, "x"), InputError) << text;
  }
}

TEST(comparison, shares_are_percent_or_numbers) {
  EXPECT_DOUBLE_EQ(0.1, share_of("10%", "--tolerance"));
  EXPECT_DOUBLE_EQ(0.025, share_of("0.025", "--tolerance"));
  for (const char* text : {"", "10 %", "x", "-1%", "100%", "1e9", "nan", "5%%"}) {
    EXPECT_THROW(share_of(text, "--tolerance"), InputError) << text;
  }
}

// n = 16: K = 16 x 17/4 - 3.2905 sqrt(16 x 17 x 33/24) = 4.4, so that the bounds are the fourth
// smallest and the fourth largest of the 136 Walsh averages. For the numbers 0, 1, ..., 15 the
// smallest are 0, 0.5, 1, 1, ..., and the largest their mirror image.
TEST(comparison, the_interval_is_that_of_the_signed_rank_test) {
  std::vector<double> ratios;
  for (int i = 0; i < 16; ++i) ratios.push_back(std::exp(i));
  const Interval ratio = typical_ratio(ratios);
  EXPECT_NEAR(std::log(ratio.value), 7.5, 1e-12);
  EXPECT_NEAR(std::log(ratio.lower), 1.0, 1e-12);
  EXPECT_NEAR(std::log(ratio.upper), 14.0, 1e-12);
}

TEST(comparison, few_pairs_determine_no_interval) {
  const Interval ratio = typical_ratio(std::vector<double>(10, 0.5));
  EXPECT_EQ(0.5, ratio.value);
  EXPECT_EQ(Verdict::same, judge(ratio, 0));
}

/// Pairs on a machine whose speed drifts by half, with noise in each figure and occasional
/// interruptions that make a figure three times too small.
Interval measured(double true_ratio, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.02);
  std::uniform_real_distribution<double> chance(0, 1);
  std::vector<double> ratios;
  for (int pair = 0; pair < 100; ++pair) {
    const double machine = 20e6 * (1 + 0.5 * pair / 100);
    const auto figure = [&](double ratio) {
      return ratio * machine * std::exp(noise(random)) / (chance(random) < 0.05 ? 3 : 1);
    };
    const double before = figure(1);
    ratios.push_back(figure(true_ratio) / before);
  }
  return typical_ratio(ratios);
}

TEST(comparison, a_program_that_is_5_percent_slower_is_found_20_times_out_of_20) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(Verdict::slower, judge(measured(1 / 1.05, seed), 0.01)) << seed;
    EXPECT_EQ(Verdict::faster, judge(measured(1.05, seed), 0.01)) << seed;
  }
}

TEST(comparison, two_equal_programs_are_not_reported_in_200_comparisons) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    EXPECT_EQ(Verdict::same, judge(measured(1, seed), 0.01)) << seed;
  }
}

}  // namespace
}  // namespace pliant::bench
