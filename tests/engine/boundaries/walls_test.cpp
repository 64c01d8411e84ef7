#include "engine/boundaries/walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pliant::test {
namespace {

/// The half-space below y = `level`; `x` and `y` are formulas of t for its velocity.
BoundaryCase floor(double level, const std::string& x = "0", const std::string& y = "0") {
  BoundaryCase boundary;
  boundary.kind = BoundaryCase::Kind::fixed;
  boundary.geometry.kind = Shape::Kind::half_space;
  boundary.geometry.point = {0, level, 0};
  boundary.geometry.normal = {0, 1, 0};
  boundary.velocity = {Expression(x), Expression(y), Expression(0.0)};
  return boundary;
}

TEST(walls, motion_of_cubic_velocity_is_followed_exactly) {
  Wall<2> wall(floor(0, "1 - 2*t + 3*t^2 - 4*t^3", "5*t^3"));
  double t = 0;
  for (const double dt : {0.3, 0.05, 0.4, 0.25}) {
    wall.move(t, dt);
    t += dt;
    EXPECT_NEAR(wall.pose().offset[0], t - t * t + t * t * t - t * t * t * t, 1e-15);
    EXPECT_NEAR(wall.pose().offset[1], 1.25 * t * t * t * t, 1e-15);
  }
}

TEST(walls, a_displacement_is_followed_with_its_own_velocity) {
  BoundaryCase boundary = floor(0);
  boundary.displacement = {Expression("sin(3*t)"), Expression("-t^2"), Expression(0.0)};
  boundary.time_increment = 1e-6;
  Wall<2> wall(boundary);
  for (int i = 0; i < 100; ++i) {
    const double t = 0.01 * i;
    wall.move(t, 0.01);
    EXPECT_NEAR(wall.velocity(t)[0], 3 * std::cos(3 * t), i == 0 ? 1e-5 : 1e-9);
    EXPECT_NEAR(wall.velocity(t)[1], -2 * t, i == 0 ? 1e-5 : 1e-9);
    EXPECT_NEAR(wall.pose().offset[0], std::sin(3 * (t + 0.01)), 1e-7);
    EXPECT_NEAR(wall.pose().offset[1], -(t + 0.01) * (t + 0.01), 1e-7);
  }
}

TEST(walls, a_displacement_is_followed_exactly_where_it_stops_within_a_step) {
  BoundaryCase boundary = floor(0);
  boundary.displacement = {Expression("0.3*min(t, 0.25)"), Expression(0.0), Expression(0.0)};
  boundary.time_increment = 1e-6;
  Wall<2> wall(boundary);
  for (int i = 0; i < 10; ++i) {
    const Point<2> shift = wall.step(0.1 * i, 0.1).shift;
    wall.move(0.1 * i, 0.1);
    EXPECT_NEAR(shift[0], 0.3 * (std::min(0.1 * i + 0.1, 0.25) - std::min(0.1 * i, 0.25)), 1e-15);
    EXPECT_NEAR(wall.pose().offset[0], 0.3 * std::min(0.1 * i + 0.1, 0.25), 1e-15);
  }
}

TEST(walls, distance_and_normal_move_with_the_wall) {
  Wall<2> wall(floor(0.5, "0", "-2"));
  EXPECT_DOUBLE_EQ(wall.distance({7, 0.75}), 0.25);
  EXPECT_DOUBLE_EQ(wall.distance({7, 0.25}), -0.25);
  wall.move(0, 0.1);
  EXPECT_DOUBLE_EQ(wall.distance({7, 0.75}), 0.45);
  EXPECT_EQ(wall.normal({7, 0.1}), (Point<2>{0, 1}));
  EXPECT_EQ(wall.velocity(3), (Point<2>{0, -2}));
}

/// The ball of radius 0.5 about (2, 0, 0), which moves along z and turns about the axis through (1,
/// 0, 0) along z.
BoundaryCase turning_ball() {
  BoundaryCase boundary;
  boundary.kind = BoundaryCase::Kind::moving_wall;
  boundary.geometry.kind = Shape::Kind::ball;
  boundary.geometry.centre = {2, 0, 0};
  boundary.geometry.radius = 0.5;
  boundary.velocity = {Expression(0.0), Expression(0.0), Expression(3.0)};
  boundary.rotation = WallRotation{{1, 0, 0}, {0, 0, 1}, Expression("2*t^2")};
  boundary.time_increment = 1e-6;
  return boundary;
}

// After a quarter turn about (1, 0) the centre of the ball is at (1, 1).
TEST(walls, that_turn_stand_where_the_angle_says) {
  constexpr double pi = 3.14159265358979324;
  const double quarter = std::sqrt(pi / 4);
  Wall<3> wall(turning_ball());
  EXPECT_NEAR(wall.distance({2, 0, 0}), -0.5, 1e-15);
  for (int i = 0; i < 10; ++i) wall.move(quarter * i / 10, quarter / 10);
  EXPECT_NEAR(wall.distance({1, 1, 3 * quarter}), -0.5, 1e-14);
  const Point<3> normal = wall.normal({1, 1.2, 3 * quarter});
  EXPECT_NEAR(normal[0], 0, 1e-14);
  EXPECT_NEAR(normal[1], 1, 1e-14);
}

// omega x r, and the centre of the ball after a quarter turn.
TEST(walls, that_turn_move_their_points_as_a_rigid_body) {
  constexpr double pi = 3.14159265358979324;
  const double quarter = std::sqrt(pi / 4), spin = 4 * quarter;
  Wall<3> wall(turning_ball());
  const RigidStep<3> step = wall.step(0, quarter);
  const Point<3> of = step.shift_of({2, 0, 0}), at = step.shift_at({1, 1, 3 * quarter});
  const Point<3> velocity = wall.motion(quarter).of({2, 0, 0});
  const Point<3> shift = {-1, 1, 3 * quarter}, right = {-spin, 0, 3};
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(of[a], shift[a], 1e-14);
    EXPECT_NEAR(at[a], shift[a], 1e-14);
    EXPECT_NEAR(velocity[a], right[a], 1e-8);
  }
}

// The area of a sphere is proportional to the square of its radius.
TEST(walls, a_ball_is_larger_than_the_parallel_surface_inside_it) {
  BoundaryCase boundary = floor(0);
  EXPECT_EQ(Wall<3>(boundary).spread({0, -0.1, 0}, 0.1), 1);
  boundary.geometry.kind = Shape::Kind::ball;
  boundary.geometry.centre = {0, 0, 0};
  boundary.geometry.radius = 1;
  const Wall<3> ball(boundary);
  EXPECT_NEAR(ball.spread({0.54, 0, 0.72}, 0.1), 1 / 0.81, 1e-3);
  EXPECT_NEAR(Wall<2>(boundary).spread({0, 0.8}, 0.2), 1 / 0.8, 3e-3);
}

TEST(walls, a_restored_wall_stands_where_it_stood) {
  Wall<2> wall(floor(0, "t", "sin(t)")), restored = wall;
  for (int i = 0; i < 5; ++i) wall.move(0.1 * i, 0.1);
  restored.restore(wall.pose());
  EXPECT_EQ(restored.distance({0.3, 0.7}), wall.distance({0.3, 0.7}));
}

TEST(walls, the_nearest_of_several_is_found_and_pressures_are_none_of_them) {
  BoundaryCase load = floor(0.2);
  load.kind = BoundaryCase::Kind::pressure;
  load.pressure = Expression("3*t");
  BoundaryCase slippery = floor(-1);
  slippery.kind = BoundaryCase::Kind::slip_wall;
  const Boundaries<2> boundaries({load, floor(-2), slippery});
  ASSERT_EQ(boundaries.walls.size(), 2u);
  ASSERT_EQ(boundaries.pressures.size(), 1u);
  EXPECT_FALSE(boundaries.walls[0].slips());
  EXPECT_TRUE(boundaries.walls[1].slips());
  EXPECT_EQ(boundaries.nearest_wall({0, 0}), (std::pair<int, double>{1, 1}));
  EXPECT_EQ(boundaries.distance_to_no_slip({0, 0}), 2);
  EXPECT_EQ(boundaries.pressures[0].pressure({}, 2), 6);
  EXPECT_TRUE(boundaries.pressures[0].acts_at({0, 0.1}));
  EXPECT_FALSE(boundaries.pressures[0].acts_at({0, 0.3}));
}

TEST(walls, without_any_the_nearest_is_infinitely_far) {
  const auto [wall, distance] = Boundaries<2>({}).nearest_wall({0, 0});
  EXPECT_EQ(wall, -1);
  EXPECT_EQ(distance, HUGE_VAL);
}

}  // namespace
}  // namespace pliant::test
