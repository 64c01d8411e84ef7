#include "engine/profile/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant::test {
namespace {

using namespace profile;

constexpr double budget = 0.01;

/// A machine that needs `seconds` for a spacing of 1.
TrySpacing machine(double seconds, double power, double finest = 0) {
  return [=](double spacing) -> FitTry {
    if (spacing < finest) return {spacing, 0, 0, false, "no memory"};
    const double time = seconds * std::pow(spacing, -power);
    return {spacing, 1, time, time <= budget};
  };
}

void expect_finest(const Fit& fit, double spacing) {
  ASSERT_GE(fit.best, 0);
  const double best = fit.tries[static_cast<std::size_t>(fit.best)].spacing;
  EXPECT_GE(best, spacing * (1 - 1e-12));
  EXPECT_LE(best, spacing * 1.03);
}

TEST(fit, finds_the_finest_spacing_within_three_percent) {
  for (const double power : {2.0, 3.0, 3.7}) {
    for (const double start : {0.01, 0.1, 0.5, 3.0}) {
      const Fit fit = fit_spacing(start, budget, 2, machine(1e-5, power));
      expect_finest(fit, std::pow(1e-5 / budget, 1 / power));
      EXPECT_LE(fit.tries.size(), 14u) << power << " " << start;
    }
  }
}

TEST(fit, takes_a_spacing_that_cannot_run_as_too_fine) {
  expect_finest(fit_spacing(0.5, budget, 2, machine(1e-5, 3, 0.2)), 0.2);
}

TEST(fit, ends_without_a_spacing_where_coarser_ones_cannot_run) {
  int tries = 0;
  const Fit fit = fit_spacing(1, budget, 2, [&](double spacing) -> FitTry {
    ++tries;
    if (spacing > 2) return {spacing, 0, 0, false, "too coarse"};
    return {spacing, 1, 1, false};
  });
  EXPECT_EQ(fit.best, -1);
  EXPECT_EQ(tries, 2);
}

TEST(fit, ends_when_it_is_interrupted) {
  const Fit fit = fit_spacing(1, budget, 2, [](double) { return std::nullopt; });
  EXPECT_TRUE(fit.tries.empty());
  EXPECT_EQ(fit.best, -1);
}

TEST(fit, keeps_whole_cells_in_a_period) {
  Case settings;
  settings.periodic.axis = {true, false, false};
  settings.periodic.lower = {-1, 0, 0};
  settings.periodic.upper = {1, 0, 0};
  EXPECT_DOUBLE_EQ(fitting_spacing(settings, 0.019), 2 / 105.);
  settings.periodic.axis = {};
  EXPECT_EQ(fitting_spacing(settings, 0.019), 0.019);
}

}  // namespace
}  // namespace pliant::test
