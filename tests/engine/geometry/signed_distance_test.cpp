#include "engine/geometry/signed_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/geometry/shapes.hpp"

namespace pliant {
namespace {

using namespace tests;

TEST(signed_distance, of_a_box_is_to_faces_inside_and_to_corners_outside) {
  const Shape shape = box({-1, -2, 0}, {1, 2, 0});
  EXPECT_EQ(signed_distance(shape, {0, 0, 0}, 2), -1);
  EXPECT_EQ(signed_distance(shape, {0.75, 1.5, 0}, 2), -0.25);
  EXPECT_EQ(signed_distance(shape, {0, 5, 0}, 2), 3);
  EXPECT_EQ(signed_distance(shape, {4, 6, 0}, 2), 5);  // 3-4-5 from the corner (1, 2)
  EXPECT_EQ(signed_distance(shape, {1, 0.3, 0}, 2), 0);
}

TEST(signed_distance, of_a_box_without_end_sees_its_other_faces_only) {
  const Shape strip = box({-0.5, -infinity, 0}, {0.5, infinity, 0});
  EXPECT_EQ(signed_distance(strip, {0.25, 1e6, 0}, 2), -0.25);
  EXPECT_EQ(signed_distance(strip, {-2, -1e6, 0}, 2), 1.5);
  const Shape plane = box({-infinity, -infinity, 0}, {infinity, infinity, 0});
  EXPECT_EQ(signed_distance(plane, {3, 4, 0}, 2), -infinity);
}

TEST(signed_distance, of_round_shapes_is_from_centre_or_axis) {
  EXPECT_EQ(signed_distance(ball({1, 1, 0}, 2), {4, 5, 0}, 2), 3);
  EXPECT_EQ(signed_distance(ball({0, 0, 0}, 5), {1, 2, 2}, 3), -2);
  EXPECT_EQ(signed_distance(ball({0, 0, 0}, 1), {0, 0, 0}, 2), -1);
  const Shape tube = cylinder({1, 0, 0}, 1, {0, 0, 1});
  EXPECT_EQ(signed_distance(tube, {4, 4, 77}, 3), 4);
}

TEST(signed_distance, of_a_capsule_is_from_its_axis_and_beyond_it_from_an_end) {
  const Shape rod = capsule({1, 0, 0}, {1, 4, 0}, 0.5);
  for (const int dimension : {2, 3}) {
    EXPECT_EQ(signed_distance(rod, {3, 2, 0}, dimension), 1.5);
    EXPECT_EQ(signed_distance(rod, {1, 1, 0}, dimension), -0.5);
    EXPECT_EQ(signed_distance(rod, {4, -4, 0}, dimension), 4.5);  // 3-4-5 from the end (1, 0)
    EXPECT_EQ(signed_distance(rod, {4, 8, 0}, dimension), 4.5);
  }
  EXPECT_EQ(signed_distance(rod, {1, 2, 2}, 3), 1.5);
  const Shape point = capsule({1, 1, 0}, {1, 1, 0}, 2);
  EXPECT_EQ(signed_distance(point, {4, 5, 0}, 2), 3);
}

TEST(signed_distance, in_two_dimensions_ignores_z) {
  EXPECT_EQ(signed_distance(ball({0, 0, 0}, 1), {3, 0, 9}, 2), 2);
  EXPECT_EQ(signed_distance(box({0, 0, 0}, {1, 1, 0}), {0.5, 2, 9}, 2), 1);
}

TEST(signed_distance, of_a_half_space_grows_along_its_normal) {
  const Shape shape = half_space({0, 1, 0}, {0.6, 0.8, 0});
  EXPECT_DOUBLE_EQ(signed_distance(shape, {3, 5, 0}, 2), 5);
  EXPECT_DOUBLE_EQ(signed_distance(shape, {0, 0, 0}, 2), -0.8);
}

TEST(signed_distance, combinations_have_the_sign_of_their_points) {
  const std::vector<Shape> parts{box({0, 0, 0}, {4, 4, 0}), ball({4, 2, 0}, 1)};
  const Shape united = combine(Shape::Kind::unite, parts);
  const Shape cut = combine(Shape::Kind::subtract, parts);
  const Shape shared = combine(Shape::Kind::intersect, parts);
  EXPECT_EQ(signed_distance(united, {4.5, 2, 0}, 2), -0.5);
  EXPECT_EQ(signed_distance(cut, {3.5, 2, 0}, 2), 0.5);
  EXPECT_EQ(signed_distance(cut, {2, 2, 0}, 2), -1);
  EXPECT_EQ(signed_distance(shared, {3.5, 2, 0}, 2), -0.5);
  EXPECT_EQ(signed_distance(shared, {1, 2, 0}, 2), 2);
}

// Central differences of step 1e-6 have an error of about 1e-10 from rounding.
TEST(signed_distance, the_outward_direction_is_its_gradient) {
  const Shape shapes[] = {
      box({-1, -2, -3}, {1, 2, 3}),
      ball({0.2, 0.1, 0}, 1.5),
      capsule({-0.5, -0.2, 0}, {0.6, 0.9, 0.4}, 0.3),
      cylinder({0.3, 0, 0}, 0.7, {0, 0.6, 0.8}),
      half_space({0, 1, 0}, {0, 0.6, 0.8}),
      combine(Shape::Kind::subtract, {box({-2, -2, -2}, {2, 2, 2}), ball({0, 0, 0}, 1)})};
  const Vector points[] = {{0.37, 0.2, -0.4}, {1.9, 2.7, 0.3}, {-0.8, -1.1, 3.9}};
  for (const Shape& shape : shapes) {
    for (const int dimension : {2, 3}) {
      if (dimension == 2 && shape.kind == Shape::Kind::cylinder) continue;
      for (const Vector& point : points) {
        const Vector direction = outward_direction(shape, point, dimension);
        for (int i = 0; i < dimension; ++i) {
          Vector ahead = point, behind = point;
          ahead[i] += 1e-6;
          behind[i] -= 1e-6;
          const double slope = (signed_distance(shape, ahead, dimension) -
                                signed_distance(shape, behind, dimension)) /
                               2e-6;
          EXPECT_NEAR(direction[i], slope, 1e-8) << static_cast<int>(shape.kind) << " " << i;
        }
      }
    }
  }
}

TEST(signed_distance, the_outward_direction_is_a_unit_vector_even_at_a_centre) {
  for (const Shape& shape :
       {ball({0, 0, 0}, 1), cylinder({0, 0, 0}, 1, {1, 0, 0}),
        cylinder({0, 0, 0}, 1, {0, 0.6, 0.8}), capsule({-1, -2, -2}, {1, 2, 2}, 1),
        capsule({0, 0, 0}, {0, 0, 0}, 1)}) {
    const Vector direction = outward_direction(shape, {0, 0, 0}, 3);
    EXPECT_DOUBLE_EQ(std::hypot(direction[0], direction[1], direction[2]), 1);
  }
  const Vector beside = outward_direction(capsule({-3, -4, 0}, {3, 4, 0}, 1), {0, 0, 0}, 2);
  EXPECT_DOUBLE_EQ(std::hypot(beside[0], beside[1]), 1);
}

TEST(bounding_box, holds_the_shape) {
  const Box<3> round = bounding_box(ball({1, 2, 3}, 0.5));
  EXPECT_EQ(round.lower, (Vector{0.5, 1.5, 2.5}));
  EXPECT_EQ(round.upper, (Vector{1.5, 2.5, 3.5}));
  const Box<3> rod = bounding_box(capsule({1, 2, 3}, {0, 4, 3}, 0.5));
  EXPECT_EQ(rod.lower, (Vector{-0.5, 1.5, 2.5}));
  EXPECT_EQ(rod.upper, (Vector{1.5, 4.5, 3.5}));
  const Box<3> tube = bounding_box(cylinder({0, 0, 0}, 2, {0, 0, 1}));
  EXPECT_EQ(tube.lower, (Vector{-2, -2, -infinity}));
  const Box<3> floor = bounding_box(half_space({0, 1, 0}, {0, 1, 0}));
  EXPECT_EQ(floor.upper, (Vector{infinity, 1, infinity}));
  EXPECT_EQ(floor.lower[1], -infinity);
}

TEST(bounding_box, of_combinations_follows_their_parts) {
  const std::vector<Shape> parts{box({0, 0, 0}, {2, 2, 2}), box({1, -1, 0}, {3, 1, 1})};
  const Box<3> united = bounding_box(combine(Shape::Kind::unite, parts));
  EXPECT_EQ(united.lower, (Vector{0, -1, 0}));
  EXPECT_EQ(united.upper, (Vector{3, 2, 2}));
  const Box<3> shared = bounding_box(combine(Shape::Kind::intersect, parts));
  EXPECT_EQ(shared.lower, (Vector{1, 0, 0}));
  EXPECT_EQ(shared.upper, (Vector{2, 1, 1}));
  const Box<3> cut = bounding_box(combine(Shape::Kind::subtract, parts));
  EXPECT_EQ(cut.upper, (Vector{2, 2, 2}));
}

}  // namespace
}  // namespace pliant
