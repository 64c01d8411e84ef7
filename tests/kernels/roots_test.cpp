#include "kernels/roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pliant::kernels {
namespace {

template <class T>
using Sse2 = xsimd::batch<T, xsimd::sse2>;

/// Largest error of `function` relative to `exact`, in units of the last place, over decades of x.
template <class T, class F, class G>
double worst_error(F function, G exact, double lower, double upper) {
  double worst = 0;
  for (double x = lower; x < upper; x *= 1.00371) {
    const T argument = static_cast<T>(x);
    const double expected = exact(static_cast<long double>(argument));
    const double unit = std::abs(expected) * std::numeric_limits<T>::epsilon();
    const double value = function(Sse2<T>(argument)).get(0);
    worst = std::max(worst, std::abs(value - expected) / unit);
  }
  return worst;
}

/// SSE2 rounds product and sum separately; Newton steps then leave errors of a few units.
constexpr double few_units = 4;

template <class T>
class roots : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(roots, Scalars);

TYPED_TEST(roots, inverse_square_root_is_accurate_to_rounding) {
  using T = TypeParam;
  EXPECT_LT(worst_error<T>([](auto x) { return inverse_square_root(x); },
                           [](long double x) { return 1 / std::sqrt(x); }, 1e-30, 1e30),
            few_units);
  EXPECT_TRUE(std::isfinite(inverse_square_root(Sse2<T>(T(0))).get(0)));
}

TYPED_TEST(roots, inverse_cube_root_is_accurate_to_rounding) {
  using T = TypeParam;
  EXPECT_LT(worst_error<T>([](auto x) { return inverse_cube_root(x); },
                           [](long double x) { return 1 / std::cbrt(x); }, 1e-30, 1e30),
            few_units);
  EXPECT_TRUE(std::isnan(inverse_cube_root(Sse2<T>(T(-1))).get(0)));
  EXPECT_TRUE(std::isnan(inverse_cube_root(Sse2<T>(T(0))).get(0)));
}

TYPED_TEST(roots, logarithm_is_accurate_to_rounding) {
  using T = TypeParam;
  const auto value = [](auto x) { return logarithm(x); };
  const auto exact = [](long double x) { return std::log(x); };
  EXPECT_LT(worst_error<T>(value, exact, 1e-30, 1e30), few_units);
  // Small compressions: no digits may be lost next to 1.
  EXPECT_LT(worst_error<T>(value, exact, 1 + 1e-6, 1.01), few_units);
  EXPECT_EQ(logarithm(Sse2<T>(T(1))).get(0), 0);
  EXPECT_TRUE(std::isnan(logarithm(Sse2<T>(T(-1))).get(0)));
}

}  // namespace
}  // namespace pliant::kernels
