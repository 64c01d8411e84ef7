#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/kernels/field.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class ghost_sums : public testing::Test {};
TYPED_TEST_SUITE(ghost_sums, Dimensions);

/// Ghosts with up to 22 random particles each; some have none at all.
template <class T, int D>
struct RandomGhosts {
  static constexpr int width = record_width<D>, particles = 40, ghosts = 50;

  RandomGhosts() : records(particles * width) {
    std::mt19937 random(5);
    std::uniform_real_distribution<T> value(-1, 1);
    for (T& x : records) x = value(random);
    for (int g = 0; g < ghosts; ++g) {
      for (int i = static_cast<int>(random() % 23); i > 0; --i) {
        record.push_back(static_cast<std::int32_t>(random() % particles));
        for (Field<T>* fit : {&linear, &constrained, &surface}) fit->push_back(value(random));
      }
      begin.push_back(static_cast<std::int64_t>(record.size()));
    }
  }

  double sum(const Field<T>& fit, int ghost, int k) const {
    double total = 0;
    for (std::int64_t i = begin[ghost]; i < begin[ghost + 1]; ++i) {
      total += fit[i] * double(records[record[i] * width + k]);
    }
    return total;
  }

  Field<T> records, linear, constrained, surface;
  std::vector<std::int64_t> begin = {0};
  std::vector<std::int32_t> record;
};

TYPED_TEST(ghost_sums, are_the_sums_of_a_plain_loop) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension, width = record_width<D>, first = 7, count = 31;
  const RandomGhosts<T, D> random;
  Field<T> sums(count * 3 * width, T(-7));
  baseline_table<T, D>().sum_ghosts({first, count, random.begin.data(), random.record.data(),
                                     random.linear.data(), random.constrained.data(),
                                     random.surface.data(), random.records.data(), sums.data()});
  // Up to 22 terms below one.
  const double tolerance = 25 * std::numeric_limits<T>::epsilon();
  for (int g = 0; g < count; ++g) {
    const T* ghost = &sums[g * 3 * width];
    for (int k = 0; k < width; ++k) {
      EXPECT_NEAR(ghost[k], random.sum(random.linear, first + g, k), tolerance);
      EXPECT_NEAR(ghost[width + k], random.sum(random.constrained, first + g, k), tolerance);
      EXPECT_NEAR(ghost[2 * width + k], random.sum(random.surface, first + g, k), tolerance);
    }
  }
}

}  // namespace
}  // namespace pliant::kernels::test
