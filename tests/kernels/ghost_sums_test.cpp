#include "kernels/ghost_sums.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "kernels/table.hpp"
#include "tests/kernels/dimension.hpp"
#include "tests/kernels/field.hpp"

namespace pliant::kernels::test {
namespace {

template <class T>
class ghost_sums : public testing::Test {};
TYPED_TEST_SUITE(ghost_sums, Dimensions);

TYPED_TEST(ghost_sums, are_the_sums_of_a_plain_loop) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension, width = record_width<D>;
  constexpr int ghosts = 50, particles = 40, first = 7, count = 31;
  std::mt19937 random(5);
  std::uniform_real_distribution<T> value(-1, 1);
  Field<T> records(particles * width), linear, constrained;
  for (T& x : records) x = value(random);
  std::vector<std::int64_t> begin = {0};
  std::vector<std::int32_t> record;
  for (int g = 0; g < ghosts; ++g) {
    for (unsigned i = 0; i < random() % 23; ++i) {  // some ghosts have no particles at all
      record.push_back(static_cast<std::int32_t>(random() % particles));
      linear.push_back(value(random));
      constrained.push_back(value(random));
    }
    begin.push_back(static_cast<std::int64_t>(record.size()));
  }
  Field<T> sums(count * 2 * width, T(-7));
  baseline_table<T, D>().sum_ghosts({first, count, begin.data(), record.data(), linear.data(),
                                     constrained.data(), records.data(), sums.data()});
  for (int g = 0; g < count; ++g) {
    for (int k = 0; k < width; ++k) {
      double by_linear = 0, by_constrained = 0;
      for (std::int64_t i = begin[first + g]; i < begin[first + g + 1]; ++i) {
        by_linear += linear[i] * double(records[record[i] * width + k]);
        by_constrained += constrained[i] * double(records[record[i] * width + k]);
      }
      // Up to 22 terms below one.
      EXPECT_NEAR(sums[g * 2 * width + k], by_linear, 25 * std::numeric_limits<T>::epsilon());
      EXPECT_NEAR(sums[(g * 2 + 1) * width + k], by_constrained,
                  25 * std::numeric_limits<T>::epsilon());
    }
  }
}

}  // namespace
}  // namespace pliant::kernels::test
