#include "engine/calibrate/optimise.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <cmath>
#include <random>

namespace pliant::calibrate {
namespace {

/// Residuals of a formula of the parameters and time, with data from the true parameters.
template <class Formula>
Evaluate evaluate(const Formula& formula, const std::vector<double>& truth, double noise,
                  int* rounds = nullptr) {
  return [=](const std::vector<std::vector<double>>& points) {
    if (rounds != nullptr) ++*rounds;
    std::vector<std::optional<Residuals>> found;
    for (const auto& point : points) {
      std::mt19937 random(3);
      std::normal_distribution<double> error(0, 1);
      Residuals residuals;
      for (int i = 1; i <= 200; ++i) {
        const double t = i / 200., data = formula(truth, t) + noise * error(random);
        residuals.push_back((formula(point, t) - data) / noise);
      }
      found.emplace_back(residuals);
    }
    return found;
  };
}

double decay(const std::vector<double>& p, double t) { return p[0] * std::exp(-p[1] * t); }

TEST(optimise, parameters_are_recovered_within_their_errors) {
  const std::vector<double> truth = {3, 5};
  int rounds = 0;
  const Calibration found = optimise({{"a", 1, 0.1, 10, true}, {"b", 1, 0, 20}},
                                     evaluate(decay, truth, 0.01, &rounds), {});
  EXPECT_TRUE(found.has_converged);
  EXPECT_LE(found.runs, 60);
  EXPECT_LT(rounds, found.runs);  // differences are evaluated together
  for (int i = 0; i < 2; ++i) {
    const Estimated& one = found.parameters[i];
    EXPECT_EQ(Determination::well, one.determination) << i;
    EXPECT_NEAR(one.value, truth[i], 3 * one.error) << i;
  }
}

// For y = a + b t at t = i/200, i = 1..200, with noise s: var b = s^2/sum (t - mean)^2, var a = var
// b times the mean of t^2, and their correlation is -mean t/sqrt(mean of t^2).
TEST(optimise, errors_and_correlation_of_a_straight_line_are_those_of_linear_regression) {
  const double noise = 0.1;
  const Calibration found = optimise(
      {{"a", 1, 0, 4}, {"b", 1, 0, 4}},
      evaluate([](const auto& p, double t) { return p[0] + p[1] * t; }, {2, 3}, noise), {});
  double sum = 0, squares = 0;
  for (const double t : [] {
         std::vector<double> times;
         for (int i = 1; i <= 200; ++i) times.push_back(i / 200.);
         return times;
       }()) {
    sum += t / 200;
    squares += t * t / 200;
  }
  double residual = 0;
  for (const double r : found.residuals) residual += r * r / 198;
  const double of_slope = noise * std::sqrt(residual / (200 * (squares - sum * sum)));
  // Finite differences of the sine have errors of first order in their step of 0.02.
  EXPECT_NEAR(found.parameters[1].error / of_slope, 1, 0.03);
  EXPECT_NEAR(found.parameters[0].error / (of_slope * std::sqrt(squares)), 1, 0.03);
  EXPECT_NEAR(found.correlation[0][1], -sum / std::sqrt(squares), 1e-6);
}

TEST(optimise, what_the_data_do_not_tell_is_said) {
  const auto formula = [](const std::vector<double>& p, double t) {
    return p[0] * t + (p[1] - p[2]) * t * t;  // only the difference matters
  };
  const Calibration found = optimise({{"a", 1, 0, 5}, {"b", 1, 0, 9}, {"c", 1, 0, 9}},
                                     evaluate(formula, {2, 4, 3}, 1e-3), {});
  EXPECT_EQ(Determination::well, found.parameters[0].determination);
  EXPECT_EQ(Determination::not_at_all, found.parameters[1].determination);
  EXPECT_EQ(Determination::not_at_all, found.parameters[2].determination);
  EXPECT_GT(found.correlation[1][2], 0.99);
}

TEST(optimise, a_bound_is_never_left_and_is_said) {
  const Calibration found =
      optimise({{"a", 1, 0.5, 2}, {"b", 1, 0.5, 20}}, evaluate(decay, {3, 5}, 0.01), {});
  EXPECT_LE(found.parameters[0].value, 2);
  EXPECT_GT(found.parameters[0].value, 1.99);
  EXPECT_EQ(Determination::not_at_all, found.parameters[0].determination);
}

TEST(optimise, no_more_runs_are_made_than_allowed) {
  OptimiserOptions options;
  options.most_runs = 8;
  options.tolerance = 1e-12;
  const Calibration found = optimise({{"a", 0.2, 0.1, 10, true}, {"b", 15, 0, 20}},
                                     evaluate(decay, {3, 5}, 0.01), options);
  EXPECT_LE(found.runs, 8);
  EXPECT_FALSE(found.has_converged);
  EXPECT_EQ(2u, found.parameters.size());
}

TEST(optimise, failing_runs_shorten_the_step_or_name_the_parameter) {
  const Evaluate good = evaluate(decay, {3, 5}, 0.01);
  const auto failing_above = [&](double limit) {
    return [=](const std::vector<std::vector<double>>& points) {
      auto found = good(points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i][0] > limit) found[i].reset();
      }
      return found;
    };
  };
  const Calibration found = optimise({{"a", 1, 0.1, 10}, {"b", 1, 0, 20}}, failing_above(3.5), {});
  EXPECT_NEAR(found.parameters[0].value, 3, 0.1);
  EXPECT_THROW(optimise({{"a", 1, 0.1, 10}, {"b", 1, 0, 20}}, failing_above(0.5), {}), InputError);
}

TEST(parameters, angles_and_values_are_inverse_and_slopes_are_derivatives) {
  for (const Parameter& parameter :
       {Parameter{"a", 1, -3, 5, false}, Parameter{"a", 1, 0.01, 50, true}}) {
    const double angle = parameter.angle(1);
    EXPECT_NEAR(parameter.value(angle), 1, 1e-12);
    const double step = 1e-6;
    const double slope =
        (parameter.value(angle + step) - parameter.value(angle - step)) / (2 * step);
    EXPECT_NEAR(parameter.slope(angle) / slope, 1, 1e-8);
  }
}

}  // namespace
}  // namespace pliant::calibrate
