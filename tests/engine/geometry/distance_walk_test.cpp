#include "engine/geometry/distance_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/signed_distance.hpp"
#include "tests/engine/geometry/shapes.hpp"

namespace pliant {
namespace {

using namespace tests;

TEST(distance_walk, values_below_the_limit_are_exact_and_all_signs_are_right) {
  const Shape shapes[] = {
      box({-1, -0.5, 0}, {1, 0.5, 0}), ball({0.1, 0, 0}, 0.8),
      combine(Shape::Kind::subtract, {box({-1, -1, 0}, {1, 1, 0}), ball({0, 0, 0}, 0.6)})};
  for (const Shape& shape : shapes) {
    for (const double limit : {0.0, 0.13, 0.5}) {
      DistanceWalk walk(shape, 2, limit);
      for (int j = -60; j <= 60; ++j) {
        for (int i = -60; i <= 60; ++i) {
          const Vector x = {i / 30., j / 30., 0};
          const double exact = signed_distance(shape, x, 2), found = walk(x);
          EXPECT_EQ(found < 0, exact < 0);
          if (std::abs(exact) < limit) {
            EXPECT_EQ(found, exact);
          } else {
            EXPECT_GE(std::abs(found), limit);
          }
        }
      }
    }
  }
}

TEST(distance_walk, a_shape_without_a_surface_is_infinitely_deep) {
  const Shape plane = box({-infinity, -infinity, 0}, {infinity, infinity, 0});
  DistanceWalk walk(plane, 2, 1);
  EXPECT_EQ(walk({0, 0, 0}), -infinity);
  EXPECT_EQ(walk({1, 0, 0}), -infinity);
}

}  // namespace
}  // namespace pliant
