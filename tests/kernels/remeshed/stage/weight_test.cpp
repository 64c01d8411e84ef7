#include "kernels/remeshed/stage/weight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/bspline_slope.hpp"

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;
constexpr double spacing = 0.02;

template <Kernel kernel>
double omega(double s) {
  return PairWeight<kernel, P>(spacing)(P(s * s * spacing * spacing)).get(0);
}

TEST(weights, quartic_is_the_slope_of_the_spline_over_the_distance) {
  for (double s = 0.01; s < 3; s += 0.007) {
    // Cancellation in the reference costs 1e-16/s.
    EXPECT_NEAR(omega<Kernel::quartic_spline>(s), -bspline_slope(P(s)).get(0) / s, 5e-14) << s;
  }
  EXPECT_NEAR(omega<Kernel::quartic_spline>(0), 1.25, 1e-15);
}

TEST(weights, polynomial_lies_within_seven_thousandths_of_the_scaled_quartic) {
  // A constant factor of the kernel cancels in the gradient. The largest difference is 0.00709.
  const double at_zero = omega<Kernel::quartic_spline>(0);
  for (double s = 0; s < 2.6; s += 0.003) {
    EXPECT_NEAR(omega<Kernel::quartic_spline_fit>(s), omega<Kernel::quartic_spline>(s) / at_zero,
                0.0071);
  }
}

TEST(weights, compact_is_the_fourth_power) {
  for (double s = 0; s < 1.75; s += 0.01) {
    EXPECT_NEAR(omega<Kernel::compact>(s), std::pow(1 - s * s / (1.75 * 1.75), 4), 1e-14);
  }
}

/// Sum over a lattice of omega times dx^4 or dx^2 dy^2.
double fourth_moment(int dimension, bool mixed) {
  double sum = 0;
  const int depth = dimension == 3 ? 2 : 0;
  for (int z = -depth; z <= depth; ++z) {
    for (int y = -2; y <= 2; ++y) {
      for (int x = -2; x <= 2; ++x) {
        const double s = std::sqrt(x * x + y * y + z * z);
        sum += omega<Kernel::fourth_order>(s) * (mixed ? x * x * y * y : x * x * x * x);
      }
    }
  }
  return sum;
}

TEST(weights, fourth_order_has_no_fourth_moments_on_square_and_cubic_lattices) {
  EXPECT_NEAR(omega<Kernel::fourth_order>(0), 1, 1e-12);
  for (const int dimension : {2, 3}) {
    for (const bool mixed : {false, true}) {
      EXPECT_NEAR(fourth_moment(dimension, mixed), 0, 1e-13) << dimension << mixed;
    }
  }
}

TEST(weights, are_positive_inside_their_support_and_zero_outside) {
  for (double s = 0; s < 2.45; s += 0.01) {
    EXPECT_GT(omega<Kernel::quartic_spline>(s), 0);
    EXPECT_GT(omega<Kernel::quartic_spline_fit>(s), 0);
    EXPECT_GT(omega<Kernel::compact>(0.7 * s), 0);
  }
  for (double s = 2.5; s < 10; s += 0.1) {
    EXPECT_EQ(omega<Kernel::quartic_spline>(s), 0);
    EXPECT_EQ(omega<Kernel::quartic_spline_fit>(s), 0);
    EXPECT_EQ(omega<Kernel::compact>(s), 0);
    EXPECT_EQ(omega<Kernel::fourth_order>(s), 0);
  }
}

}  // namespace
}  // namespace pliant::kernels
