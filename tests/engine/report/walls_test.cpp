#include "engine/report/walls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/signed_distance.hpp"

namespace pliant::test {
namespace {

using report::WallPicture;

const Box<3> unit_box = {{-1, -1, -1}, {1, 1, 1}};

std::vector<WallPicture> pictures(int dimension, const Shape& shape,
                                  const VectorExpression& velocity = {}) {
  Case a_case;
  a_case.dimension = dimension;
  BoundaryCase boundary;
  boundary.name = "wall";
  boundary.kind = BoundaryCase::Kind::moving_wall;
  boundary.geometry = shape;
  boundary.velocity = velocity;
  a_case.boundaries.push_back(boundary);
  return report::picture_walls(a_case, unit_box, {0, 0.5, 2});
}

Vector normal_of(const WallPicture& wall, std::size_t triangle) {
  const auto corner = [&](std::size_t i) { return wall.vertex[wall.triangle[3 * triangle + i]]; };
  const Vector a = corner(0), b = corner(1), c = corner(2);
  Vector u, v;
  for (int i = 0; i < 3; ++i) u[i] = b[i] - a[i], v[i] = c[i] - a[i];
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double area_of(const WallPicture& wall) {
  double area = 0;
  for (std::size_t t = 0; t < wall.triangle.size() / 3; ++t) {
    const Vector n = normal_of(wall, t);
    area += std::hypot(n[0], n[1], n[2]) / 2;
  }
  return area;
}

/// The enclosed volume is a sixth of the sum of the triple products of the corners.
double volume_of(const WallPicture& wall) {
  double volume = 0;
  for (std::size_t t = 0; t < wall.triangle.size() / 3; ++t) {
    const Vector n = normal_of(wall, t), a = wall.vertex[wall.triangle[3 * t]];
    volume += (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / 6;
  }
  return volume;
}

TEST(wall_pictures, of_a_half_space_are_its_face_in_the_box) {
  Shape shape;
  shape.kind = Shape::Kind::half_space;
  shape.point = {0, 0, 0.25};
  shape.normal = {0, 0.6, 0.8};
  const auto walls = pictures(3, shape);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_TRUE(walls[0].is_plane);
  for (const Vector& x : walls[0].vertex) {
    EXPECT_NEAR(0.6 * x[1] + 0.8 * (x[2] - 0.25), 0, 1e-12);
  }
  EXPECT_NEAR(area_of(walls[0]), 2 * 2 / 0.8, 1e-12);
  for (std::size_t t = 0; t < walls[0].triangle.size() / 3; ++t) {
    EXPECT_GT(normal_of(walls[0], t)[2], 0);
  }
}

TEST(wall_pictures, outside_the_box_are_left_out) {
  Shape shape;
  shape.kind = Shape::Kind::half_space;
  shape.point = {0, 0, -2};
  shape.normal = {0, 0, 1};
  EXPECT_TRUE(pictures(3, shape).empty());
  shape.kind = Shape::Kind::ball;
  shape.centre = {3, 0, 0};
  shape.radius = 1;
  EXPECT_TRUE(pictures(3, shape).empty());
}

// The volume inside the chords of a sphere, 40 cells across, is less than 1 % too small.
TEST(wall_pictures, of_a_ball_are_closed_and_have_its_volume) {
  Shape shape;
  shape.kind = Shape::Kind::ball;
  shape.radius = 0.5;
  const WallPicture wall = pictures(3, shape)[0];
  EXPECT_NEAR(volume_of(wall) / (4 * M_PI / 3 * 0.125), 1, 0.01);
  EXPECT_FALSE(wall.is_plane);
}

// A collar: a block with a round hole, none of whose sides lies on the sampling lattice.
TEST(wall_pictures, of_a_collar_have_sharp_edges) {
  Shape block, hole, collar;
  block.lower = {-0.83, -0.71, -0.37};
  block.upper = {0.79, 0.77, 0.41};
  hole.kind = Shape::Kind::cylinder;
  hole.axis = {0, 0, 1};
  hole.radius = 0.4;
  collar.kind = Shape::Kind::subtract;
  collar.operands = {block, hole};
  const WallPicture wall = pictures(3, collar)[0];
  const double thickness = 0.78;
  const double exact = (1.62 * 1.48 - M_PI * 0.16) * thickness;
  EXPECT_NEAR(volume_of(wall) / exact, 1, 5e-4);
  EXPECT_NEAR(
      area_of(wall) / (2 * exact / thickness + 2 * 3.1 * thickness + M_PI * 0.8 * thickness), 1,
      2e-3);
  for (const Vector& x : wall.vertex) EXPECT_NEAR(signed_distance(collar, x, 3), 0, 1e-3);
}

TEST(wall_pictures, of_a_box_are_closed_where_the_picture_ends) {
  Shape shape;
  shape.lower = {-0.5, -INFINITY, -0.5};
  shape.upper = {0.5, INFINITY, 0.5};
  EXPECT_NEAR(volume_of(pictures(3, shape)[0]), 2, 1e-12);
}

TEST(wall_pictures, in_a_plane_fill_their_solids) {
  Shape shape;
  shape.kind = Shape::Kind::half_space;
  shape.point = {0, 0.5, 0};
  shape.normal = {0, -1, 0};
  EXPECT_NEAR(area_of(pictures(2, shape)[0]), 1, 1e-12);
  shape.kind = Shape::Kind::ball;
  shape.radius = 0.5;
  EXPECT_NEAR(area_of(pictures(2, shape)[0]), M_PI / 4, 0.01);
}

TEST(wall_pictures, move_with_the_integral_of_the_velocity) {
  Shape shape;
  shape.kind = Shape::Kind::ball;
  shape.radius = 0.5;
  const auto walls = pictures(3, shape, {Expression("3*t^2"), Expression(2), Expression(0)});
  ASSERT_EQ(walls[0].shift.size(), 3u);
  EXPECT_NEAR(walls[0].shift[1][0], 0.125, 1e-12);
  EXPECT_NEAR(walls[0].shift[2][0], 8, 1e-12);
  EXPECT_NEAR(walls[0].shift[2][1], 4, 1e-12);
  EXPECT_TRUE(pictures(3, shape)[0].shift.empty());
}

}  // namespace
}  // namespace pliant::test
