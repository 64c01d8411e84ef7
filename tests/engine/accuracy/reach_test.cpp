#include "engine/accuracy/reach.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant::accuracy {
namespace {

const double no_answer = std::nan("");

/// A method of second order in 2D with time steps proportional to the spacing: N = 1/h^2, t =
/// 1/h^3.
std::vector<Rated> second_order_in_2d(std::vector<double> spacings) {
  std::vector<Rated> rungs;
  for (const double h : spacings) rungs.push_back({1 / (h * h), 1 / (h * h * h), h * h});
  return rungs;
}

TEST(reach, a_power_law_is_interpolated_exactly) {
  const auto rungs = second_order_in_2d({0.5, 0.2, 0.05, 0.01});
  for (const double error : {0.1, 0.01, 0.003}) {
    const Cost cost = cost_of(error, rungs);
    EXPECT_EQ(cost.certainty, Certainty::interpolated);
    EXPECT_NEAR(cost.particles * error, 1, 1e-12);
    EXPECT_NEAR(cost.seconds * std::pow(error, 1.5), 1, 1e-12);
  }
}

TEST(reach, an_error_that_crosses_zero_is_not_taken_for_a_good_answer) {
  auto rungs = second_order_in_2d({0.4, 0.2, 0.1, 0.05});
  rungs[1].error = 1e-6;  // by chance
  const std::vector<double> errors = envelope(rungs);
  EXPECT_DOUBLE_EQ(errors[1], rungs[2].error);
  EXPECT_GE(cost_of(0.005, rungs).particles, rungs[2].particles);
}

TEST(reach, the_envelope_never_grows_towards_finer_spacings) {
  const std::vector<Rated> rungs = {{1, 1, 0.03}, {2, 2, 0.05}, {3, 3, 0.01}, {4, 4, 0.02}};
  EXPECT_EQ(envelope(rungs), (std::vector<double>{0.05, 0.05, 0.02, 0.02}));
}

TEST(reach, what_is_not_bracketed_is_marked) {
  const auto rungs = second_order_in_2d({0.2, 0.1, 0.05});
  EXPECT_EQ(cost_of(0.1, rungs).certainty, Certainty::at_most);
  EXPECT_DOUBLE_EQ(cost_of(0.1, rungs).particles, rungs[0].particles);
  EXPECT_EQ(cost_of(0.005, rungs).certainty, Certainty::unconfirmed);
  EXPECT_EQ(cost_of(0.001, rungs).certainty, Certainty::not_reached);
  EXPECT_EQ(cost_of(0.1, {}).certainty, Certainty::not_reached);
}

TEST(reach, runs_without_an_answer_have_no_influence) {
  auto rungs = second_order_in_2d({0.5, 0.2, 0.05, 0.01});
  const Cost before = cost_of(0.02, rungs);
  rungs.insert(rungs.begin() + 1, {1, 1, no_answer});
  rungs.push_back({1e6, no_answer, no_answer});
  const Cost after = cost_of(0.02, rungs);
  EXPECT_DOUBLE_EQ(before.seconds, after.seconds);
  EXPECT_EQ(before.certainty, after.certainty);
}

TEST(reach, an_answer_without_any_error_has_a_cost) {
  const std::vector<Rated> rungs = {{10, 1, 0.1}, {100, 10, 0}, {1000, 100, 0}};
  const Cost cost = cost_of(0.01, rungs);
  EXPECT_EQ(cost.certainty, Certainty::interpolated);
  EXPECT_GT(cost.seconds, 1);
  EXPECT_LT(cost.seconds, 10);
}

}  // namespace
}  // namespace pliant::accuracy
