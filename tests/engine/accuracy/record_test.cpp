#include "engine/accuracy/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant::accuracy {
namespace {

RungRecord rung(const std::string& spacing, std::int64_t particles, std::vector<double> seconds,
                double error) {
  RungRecord made;
  made.settings = {"discretisation.spacing=" + spacing};
  made.particles = particles;
  made.seconds = std::move(seconds);
  made.error = error;
  return made;
}

AccuracyRecord record() {
  AccuracyRecord made;
  made.machine = {"a machine"};
  RungRecord missing = rung("1/64", 0, {}, std::nan(""));
  missing.message = "stopped by the time limit";
  made.rows = {{"block",
                "compact",
                {rung("1/8", 100, {1, 3, 2}, 0.1), rung("1/16", 1000, {20}, 0.005),
                 rung("1/32", 10000, {200}, 0.004), missing}}};
  return made;
}

TEST(accuracy_record, takes_the_median_of_the_repetitions) {
  EXPECT_EQ(record().rows[0].rungs[0].median_seconds(), 2);
  EXPECT_EQ(rung("1", 1, {1, 4}, 0).median_seconds(), 2.5);
  EXPECT_TRUE(std::isnan(rung("1", 1, {}, 0).median_seconds()));
}

TEST(accuracy_record, shows_costs_and_runs_as_tables) {
  const std::string markdown = markdown_of(record());
  // For 1 %, log(0.1/0.01)/log(0.1/0.005) = 0.7686 of the way: 2 s 10^0.7686 and 100 x 10^0.7686.
  EXPECT_NE(markdown.find("| block | compact | 5.05 s, 252 | 11.7 s, 587 | - |"), std::string::npos)
      << markdown;
  EXPECT_NE(markdown.find("| block | compact | 1/16 | 1000 | 0 | 20 | 0.5 |"), std::string::npos);
  EXPECT_NE(markdown.find("| 1/64 | - | - | - | stopped by the time limit |"), std::string::npos);
  EXPECT_NE(text_of(record()).find("11.7 s, 587"), std::string::npos);
}

}  // namespace
}  // namespace pliant::accuracy
