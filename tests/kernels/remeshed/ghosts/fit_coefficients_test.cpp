#include "kernels/remeshed/ghosts/fit_coefficients.hpp"

#include <gtest/gtest.h>

namespace pliant::kernels::test {
namespace {

TEST(fit_pair, holds_a_record_and_the_cells_to_it) {
  const std::array<std::int32_t, 3> cells = {-128, 127, -3};
  const FitPair pair = fit_pair<3>(0x7fffffff, cells), other = with_record(pair, 5);
  EXPECT_EQ(record_of(pair), 0x7fffffff);
  EXPECT_EQ(record_of(other), 5);
  for (int a = 0; a < 3; ++a) EXPECT_EQ(cells_along(other, a), cells[a]);
}

TEST(fit_coefficients, are_a_weight_times_a_polynomial) {
  FitTerms<double, 2> terms;
  terms.steepness = 0.25;
  terms.linear = {1, 2, 0};
  terms.surface = {3, 0, 1};
  terms.constrained = {1, 0, 2, 4};
  const double r[2] = {1, 1}, phi = -0.5, w = 0.25;  // 1 - r^2/4 = 1/2
  const FitCoefficients<double> fit = fit_coefficients(terms, r, phi);
  EXPECT_DOUBLE_EQ(fit.linear, w * 3);
  EXPECT_DOUBLE_EQ(fit.surface, w * 4);
  EXPECT_DOUBLE_EQ(fit.constrained, w * phi * (1 + 2 - 2));
}

TEST(fit_weight, reaches_farther_where_it_is_broad_and_ends_where_it_vanishes) {
  FitTerms<double, 2> terms;
  terms.steepness = 1;
  const double beyond[2] = {1.5, 0};
  EXPECT_EQ(fit_weight(terms, beyond), 0);
  terms.broad = {1, 0};
  EXPECT_DOUBLE_EQ(fit_weight(terms, beyond), 1);
}

}  // namespace
}  // namespace pliant::kernels::test
