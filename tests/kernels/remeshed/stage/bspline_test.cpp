#include "kernels/remeshed/stage/bspline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/bspline_slope.hpp"

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;

double w(double x) { return bspline(P(std::abs(x))).get(0); }
double slope(double s) { return bspline_slope(P(s)).get(0); }

TEST(bspline, is_a_partition_of_unity_with_constant_moments) {
  // Centred B-splines of order 5 reproduce constant and linear functions; the second central moment
  // is that of five uniform distributions, 5/12.
  for (double x = 0; x < 1; x += 0.01) {
    double zeroth = 0, first = 0, second = 0;
    for (int i = -3; i <= 4; ++i) {
      zeroth += w(x - i);
      first += (x - i) * w(x - i);
      second += (x - i) * (x - i) * w(x - i);
    }
    EXPECT_NEAR(zeroth, 1, 1e-14);
    EXPECT_NEAR(first, 0, 1e-14);
    EXPECT_NEAR(second, 5. / 12, 1e-14);
  }
}

TEST(bspline, slope_is_the_derivative) {
  for (double s = 0.01; s < 2.7; s += 0.013) {
    const double step = 1e-5;
    // Central difference: error step^2 w'''/6 < 1e-10, and rounding 1e-16/step.
    EXPECT_NEAR(slope(s), (w(s + step) - w(s - step)) / (2 * step), 2e-10);
  }
}

TEST(bspline, integrates_to_one_in_every_dimension) {
  const int n = 20000;
  const double ds = 2.5 / n;
  double line = 0, plane = 0, space = 0;
  for (int k = 0; k < n; ++k) {
    const double s = (k + 0.5) * ds;  // midpoint rule, error of order ds^2 = 1.6e-8
    line += 2 * w(s) * ds;
    plane += 2 * std::numbers::pi * s * w(s) * ds;
    space += 4 * std::numbers::pi * s * s * w(s) * ds;
  }
  EXPECT_NEAR(bspline_normalisation<1> * line, 1, 1e-7);
  EXPECT_NEAR(bspline_normalisation<2> * plane, 1, 1e-7);
  EXPECT_NEAR(bspline_normalisation<3> * space, 1, 1e-7);
}

}  // namespace
}  // namespace pliant::kernels
