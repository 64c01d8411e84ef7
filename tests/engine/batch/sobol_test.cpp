#include "engine/batch/sobol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace pliant::test {
namespace {

using batch::SobolSequence;

constexpr int count = 256;

std::vector<std::vector<double>> points(int dimensions, std::uint64_t seed) {
  SobolSequence sequence(dimensions, seed);
  std::vector<std::vector<double>> all(count);
  for (auto& point : all) point = sequence.next();
  return all;
}

// The defining property of direction numbers: they are a basis in every dimension.
TEST(sobol, has_one_point_in_each_of_as_many_parts_in_every_dimension) {
  const auto all = points(SobolSequence::most_dimensions, 7);
  for (std::size_t d = 0; d < SobolSequence::most_dimensions; ++d) {
    std::set<int> parts;
    for (const auto& point : all) parts.insert(static_cast<int>(point[d] * count));
    EXPECT_EQ(parts.size(), static_cast<std::size_t>(count)) << d;
    EXPECT_EQ(*parts.begin(), 0);
    EXPECT_EQ(*parts.rbegin(), count - 1);
  }
}

// The first two dimensions are a (0, m, 2)-net.
TEST(sobol, has_one_point_in_each_rectangle_of_equal_area) {
  const auto all = points(2, 3);
  for (int columns = 1; columns <= count; columns *= 2) {
    std::set<std::pair<int, int>> rectangles;
    for (const auto& point : all) {
      rectangles.emplace(static_cast<int>(point[0] * columns),
                         static_cast<int>(point[1] * (count / columns)));
    }
    EXPECT_EQ(rectangles.size(), static_cast<std::size_t>(count)) << columns;
  }
}

// The error of the mean of a smooth function falls much faster than 1/sqrt(count).
TEST(sobol, integrates_in_high_dimensions) {
  double sum = 0;
  for (const auto& point : points(SobolSequence::most_dimensions, 11)) {
    double product = 1;
    for (const double x : point) product *= 1 + 0.2 * (x - 0.5);
    sum += product;
  }
  const double standard_error = std::sqrt(SobolSequence::most_dimensions * 0.04 / 12 / count);
  EXPECT_LT(std::abs(sum / count - 1), standard_error / 3);
}

TEST(sobol, depends_on_its_seed_only) {
  EXPECT_EQ(points(3, 5), points(3, 5));
  EXPECT_NE(points(3, 5), points(3, 6));
}

TEST(sobol, of_no_or_too_many_dimensions_is_refused) {
  EXPECT_THROW(SobolSequence(0, 1), std::invalid_argument);
  EXPECT_THROW(SobolSequence(SobolSequence::most_dimensions + 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace pliant::test
