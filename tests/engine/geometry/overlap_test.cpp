#include "engine/geometry/overlap.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace pliant::tests {
namespace {

Shape ball(const Vector& centre, double radius) {
  Shape shape;
  shape.kind = Shape::Kind::ball;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

Shape box(const Vector& lower, const Vector& upper) {
  Shape shape;
  shape.lower = lower;
  shape.upper = upper;
  return shape;
}

// The deepest point of a lens of thickness w is w/2 from both surfaces.
TEST(overlap, is_half_the_thickness_of_a_lens) {
  for (const int dimension : {2, 3}) {
    for (const double distance : {1.6, 1.9}) {
      EXPECT_NEAR(overlap(ball({}, 1), ball({distance, 0, 0}, 1), 0.02, dimension),
                  (2 - distance) / 2, 2e-5);
    }
  }
}

// A lens thinner than the distance between the sample points.
TEST(overlap, finds_lenses_between_the_points) {
  for (const double place : {0., 0.013, 0.037, 0.061}) {
    EXPECT_NEAR(overlap(ball({place, 0.02, 0}, 1), ball({1.96 + place, 0.02, 0}, 1), 0.1, 2), 0.02,
                1e-4);
  }
}

// Their faces lie on the sample points, but for an offset.
TEST(overlap, of_boxes_on_a_lattice_is_half_of_what_they_share) {
  for (const int dimension : {2, 3}) {
    EXPECT_NEAR(overlap(box({0, 0, 0}, {1, 1, 1}), box({0.95, 0, 0}, {2, 1, 1}), 0.1, dimension),
                0.025, 1e-4);
    EXPECT_NEAR(overlap(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}), 0.1, dimension), 0,
                1e-4);
  }
}

TEST(overlap, is_negative_for_shapes_that_stand_apart) {
  EXPECT_LT(overlap(ball({}, 1), ball({2.1, 0, 0}, 1), 0.02, 2), 0);
  EXPECT_LT(overlap(ball({}, 1), ball({5, 0, 0}, 1), 0.02, 3), -2.9);
}

TEST(overlap, of_boxes_without_end_is_looked_for_across_them) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Shape left = box({-1, -infinity, 0}, {0, infinity, 0});
  EXPECT_NEAR(overlap(left, box({0, -infinity, 0}, {1, infinity, 0}), 0.1, 2), 0, 1e-4);
  EXPECT_NEAR(overlap(left, box({-0.6, -infinity, 0}, {1, infinity, 0}), 0.1, 2), 0.3, 1e-4);
}

}  // namespace
}  // namespace pliant::tests
