#include <gtest/gtest.h>

#include "tests/kernels/random_ghosts.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class ghost_sums : public testing::Test {};
TYPED_TEST_SUITE(ghost_sums, Dimensions);

TYPED_TEST(ghost_sums, are_the_sums_of_a_plain_loop) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension, width = record_width<D>, first = 7, count = 31;
  using Fit = FitCoefficients<double>;
  const RandomGhosts<T, D> random;
  Field<T> sums(count * 3 * width, T(-7));
  baseline_table<T, D>().sum_ghosts(random.sums(first, count, sums.data()));
  // Up to 22 terms below one.
  const double tolerance = 25 * std::numeric_limits<T>::epsilon();
  for (int g = 0; g < count; ++g) {
    const T* ghost = &sums[g * 3 * width];
    for (int k = 0; k < width; ++k) {
      EXPECT_NEAR(ghost[k], random.sum(&Fit::linear, first + g, k), tolerance);
      EXPECT_NEAR(ghost[width + k], random.sum(&Fit::constrained, first + g, k), tolerance);
      EXPECT_NEAR(ghost[2 * width + k], random.sum(&Fit::surface, first + g, k), tolerance);
    }
  }
}

TYPED_TEST(ghost_sums, of_velocities_alone_are_the_same) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension, width = record_width<D>, first = 3, count = 29;
  const RandomGhosts<T, D> random;
  Field<T> all(count * 3 * width), velocities(count * 3 * width);
  baseline_table<T, D>().sum_ghosts(random.sums(first, count, all.data()));
  baseline_table<T, D>().sum_velocities(random.sums(first, count, velocities.data()));
  for (int g = 0; g < count; ++g) {
    const int fit = random.wall_begin[first + g] < 0 ? 0 : 1;
    for (int a = 0; a < D; ++a) {
      const int u = (3 * g + fit) * width + RecordPlace<D>::velocity + a;
      EXPECT_EQ(velocities[u], all[u]);
    }
  }
}

}  // namespace
}  // namespace pliant::kernels::test
