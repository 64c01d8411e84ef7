#include "kernels/remeshed/stage/sixth_difference.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pliant::kernels::test {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;
constexpr int length = 32, pad = 4;  // slots of a line, and zeros on both sides
constexpr LineOffsets line = {{-2, -1, 1, 2}};
constexpr FarOffsets far = {-3, 3};

struct Line {
  alignas(64) std::array<double, length + 2 * pad> field = {};
  alignas(64) std::array<Mark, length + 2 * pad> inside = {};

  explicit Line(double (*f)(double)) {
    for (int i = 0; i < length; ++i) {
      field[pad + i] = f(i);
      inside[pad + i] = 1;
    }
  }
  std::array<double, length> differences() const {
    std::array<double, length> result;
    for (int i = 0; i < length; i += static_cast<int>(P::size)) {
      sixth_difference<P>(&field[pad + i], &inside[pad + i], line, far).store_unaligned(&result[i]);
    }
    return result;
  }
};

TEST(sixth_difference, vanishes_inside_for_polynomials_of_the_fifth_degree) {
  const Line quintic([](double x) { return std::pow(x / 8 - 2, 5) + x * x; });
  const auto result = quintic.differences();
  for (int i = 3; i < length - 3; ++i) EXPECT_NEAR(result[i], 0, 1e-12) << i;
}

TEST(sixth_difference, damps_the_shortest_wave_as_the_fourth_difference_does) {
  const Line zigzag([](double x) { return std::fmod(x, 2) == 0 ? 1. : -1.; });
  const auto result = zigzag.differences();
  for (int i = 3; i < length - 3; ++i) EXPECT_EQ(result[i], 16 * zigzag.field[pad + i]) << i;
  const P inside = sixth_differences_inside<P, 1>(&zigzag.field[pad + 8], {line}, {far});
  EXPECT_EQ(inside.get(0), 16 * zigzag.field[pad + 8]);
}

// Also beside a hole, where third differences are used.
TEST(sixth_difference, keeps_the_sum_over_what_is_inside) {
  Line wave([](double x) { return std::sin(0.7 * x) + 0.01 * x; });
  wave.inside[pad + 13] = 0;
  const auto result = wave.differences();
  double sum = 0, size = 0;
  for (int i = 0; i < length; ++i) {
    if (i == 13) continue;
    sum += result[i];
    size += std::abs(result[i]);
  }
  EXPECT_GT(size, 0.1);
  EXPECT_NEAR(sum, 0, 1e-12);
}

}  // namespace
}  // namespace pliant::kernels::test
