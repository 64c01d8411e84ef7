#include "engine/blocks/point_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "engine/blocks/numbering.hpp"

namespace pliant {
namespace {

template <class T, int D>
struct Cloud {
  std::array<std::vector<T>, D> x;

  std::size_t size() const { return x[0].size(); }
  std::array<std::span<const T>, D> view() const {
    std::array<std::span<const T>, D> spans;
    for (int a = 0; a < D; ++a) spans[a] = x[a];
    return spans;
  }
};

/// Points in the unit cube, denser towards the origin: their distances vary by a factor of 100.
template <class T, int D>
Cloud<T, D> graded_cloud(int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  Cloud<T, D> cloud;
  for (int p = 0; p < count; ++p) {
    for (auto& component : cloud.x) {
      const double s = share(random);
      component.push_back(static_cast<T>(s * s));
    }
  }
  return cloud;
}

template <class T, int D>
std::vector<std::vector<int>> neighbours_by_trying_all(const Cloud<T, D>& cloud,
                                                       const PointBlocks& found, double radius) {
  std::vector<int> block_of(cloud.size());
  for (int b = 0; b < found.blocks.count(); ++b) {
    for (std::int64_t s = found.first_slot[b]; s < found.first_slot[b + 1]; ++s) {
      block_of[found.order[s]] = b;
    }
  }
  const int count = found.blocks.count();
  std::vector<char> are_near(count * count);
  for (std::size_t p = 0; p < cloud.size(); ++p) {
    for (std::size_t q = 0; q < cloud.size(); ++q) {
      double squared_distance = 0;
      for (int a = 0; a < D; ++a) {
        const double d = static_cast<double>(cloud.x[a][p]) - static_cast<double>(cloud.x[a][q]);
        squared_distance += d * d;
      }
      if (block_of[p] != block_of[q] && squared_distance <= radius * radius) {
        are_near[block_of[p] * count + block_of[q]] = 1;
      }
    }
  }
  std::vector<std::vector<int>> lists(count);
  for (int b = 0; b < count * count; ++b) {
    if (are_near[b]) lists[b / count].push_back(b % count);
  }
  return lists;
}

template <class T, int D>
void expect_blocks_of_every_point(const Cloud<T, D>& cloud, double radius, int block_size) {
  const PointBlocks found = blocks_of_points<T, D>(cloud.view(), radius, block_size);
  std::vector<std::int64_t> points = found.order;
  std::sort(points.begin(), points.end());
  for (std::size_t p = 0; p < cloud.size(); ++p) ASSERT_EQ(points[p], static_cast<std::int64_t>(p));

  const auto count = static_cast<std::int64_t>(cloud.size());
  ASSERT_EQ(found.blocks.count(), (count + block_size - 1) / block_size);
  ASSERT_EQ(found.first_slot.size(), static_cast<std::size_t>(found.blocks.count()) + 1);
  EXPECT_EQ(found.first_slot.front(), 0);
  EXPECT_EQ(found.first_slot.back(), count);
  for (int b = 0; b < found.blocks.count(); ++b) {
    const std::int64_t size = found.first_slot[b + 1] - found.first_slot[b];
    EXPECT_GE(size, count / found.blocks.count());
    EXPECT_LE(size, block_size);
  }
  EXPECT_EQ(found.blocks.neighbours, (neighbours_by_trying_all<T, D>(cloud, found, radius)));
}

template <class Type>
struct PointBlocksOf : testing::Test {};
template <class Scalar, int dimension>
struct Kind {
  using T = Scalar;
  static constexpr int D = dimension;
};
using Kinds = testing::Types<Kind<double, 2>, Kind<double, 3>, Kind<float, 2>, Kind<float, 3>>;
TYPED_TEST_SUITE(PointBlocksOf, Kinds);

TYPED_TEST(PointBlocksOf, irregular_clouds_are_neighbours_exactly_where_points_are_near) {
  using T = typename TypeParam::T;
  constexpr int D = TypeParam::D;
  const auto cloud = graded_cloud<T, D>(600);
  for (const double radius : {0.0, 0.02, 0.2, 2.0}) {
    for (const int block_size : {1, 7, 64, 900}) {
      expect_blocks_of_every_point<T, D>(cloud, radius, block_size);
    }
  }
}

TYPED_TEST(PointBlocksOf, equal_and_far_points_are_no_exception) {
  using T = typename TypeParam::T;
  constexpr int D = TypeParam::D;
  auto cloud = graded_cloud<T, D>(300);
  for (auto& component : cloud.x) {
    component.insert(component.end(), 200, T(0.25));
    component.push_back(T(1e9));
  }
  expect_blocks_of_every_point<T, D>(cloud, 0.05, 20);
  expect_blocks_of_every_point<T, D>(Cloud<T, D>{}, 0.05, 20);
}

TEST(point_blocks, points_of_a_block_are_near_each_other) {
  constexpr int side = 64, block_size = 256;
  Cloud<double, 2> cloud;
  for (int i = 0; i < side * side; ++i) {
    cloud.x[0].push_back(i % side);
    cloud.x[1].push_back(i / side);
  }
  const PointBlocks found = blocks_of_points<double, 2>(cloud.view(), 1, block_size);
  // Stretches of this length of a Hilbert curve are squares of 16 by 16 points with a neighbour on
  // each of the four sides; rows of points would be 64 by 4.
  for (int b = 0; b < found.blocks.count(); ++b) {
    EXPECT_LE(found.blocks.neighbours[b].size(), 4u);
    for (int a = 0; a < 2; ++a) {
      double lower = side, upper = 0;
      for (std::int64_t s = found.first_slot[b]; s < found.first_slot[b + 1]; ++s) {
        lower = std::min(lower, cloud.x[a][found.order[s]]);
        upper = std::max(upper, cloud.x[a][found.order[s]]);
      }
      EXPECT_EQ(upper - lower, 15);
    }
  }
}

TEST(point_blocks, join_those_of_other_bodies) {
  const auto cloud = graded_cloud<double, 2>(500);
  const PointBlocks one = blocks_of_points<double, 2>(cloud.view(), 0.1, 100),
                    other = blocks_of_points<double, 2>(cloud.view(), 0.1, 250);
  const scheduler::Blocks all = join_blocks(std::vector{one.blocks, other.blocks});
  ASSERT_EQ(all.count(), 7);
  EXPECT_EQ(all.neighbours[0], one.blocks.neighbours[0]);
  EXPECT_EQ(all.neighbours[5], std::vector<int>{6});
}

TEST(point_blocks, what_cannot_be_placed_is_refused) {
  const auto blocks = [](double x, double radius, int block_size) {
    const std::vector<double> first = {0, x, 1}, second = {0, 1, 2};
    return blocks_of_points<double, 2>({first, second}, radius, block_size);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity(),
                   nan = std::numeric_limits<double>::quiet_NaN(),
                   largest = std::numeric_limits<double>::max();
  EXPECT_NO_THROW(blocks(1, 1, 1));
  EXPECT_THROW(blocks(nan, 1, 1), std::invalid_argument);
  EXPECT_THROW(blocks(-infinity, 1, 1), std::invalid_argument);
  EXPECT_THROW(blocks(1, nan, 1), std::invalid_argument);
  EXPECT_THROW(blocks(1, -1, 1), std::invalid_argument);
  EXPECT_THROW(blocks(1, infinity, 1), std::invalid_argument);
  EXPECT_THROW(blocks(1, 1, 0), std::invalid_argument);
  const std::vector<double> far = {-largest, largest}, short_list = {0};
  EXPECT_THROW((blocks_of_points<double, 2>({far, far}, 1, 1)), std::invalid_argument);
  EXPECT_THROW((blocks_of_points<double, 2>({far, short_list}, 1, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace pliant
