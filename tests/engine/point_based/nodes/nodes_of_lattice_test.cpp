#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/nodes/lattice_nodes.hpp"
#include "engine/point_based/nodes/nodes_at_walls.hpp"

namespace pliant::test {
namespace {

using point_based::lattice_nodes;

template <int D>
double volume_of(const point_based::NodeCloud<D>& cloud) {
  return std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.0);
}

Shape box(const Vector& lower, const Vector& upper) {
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.lower = lower;
  shape.upper = upper;
  return shape;
}

TEST(lattice_nodes, of_a_box_lie_on_its_faces_and_fill_it_exactly) {
  const auto cloud = lattice_nodes<3>(box({0, 1, 2}, {1, 1.5, 2.25}), 0.125);
  EXPECT_EQ(cloud.positions.size(), 9 * 5 * 3);
  EXPECT_NEAR(volume_of(cloud), 1 * 0.5 * 0.25, 1e-14);
  double least = 1, most = 0;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    least = std::min(least, cloud.volumes[i]);
    most = std::max(most, cloud.volumes[i]);
  }
  const double cell = std::pow(0.125, 3);
  EXPECT_NEAR(least, cell / 8, 1e-15);
  EXPECT_NEAR(most, cell, 1e-15);
}

// The lattice does not fit: nodes on the last layer get the part that sticks out.
TEST(lattice_nodes, of_a_box_between_lattice_points_have_its_volume) {
  const auto cloud = lattice_nodes<2>(box({0, 0, 0}, {1, 0.47, 0}), 0.1);
  EXPECT_NEAR(volume_of(cloud), 0.47, 1e-3);
}

Shape ball_at(const Vector& centre, double radius) {
  Shape ball;
  ball.kind = Shape::Kind::ball;
  ball.centre = centre;
  ball.radius = radius;
  return ball;
}

Shape half_space(const Vector& point, const Vector& normal) {
  Shape shape;
  shape.kind = Shape::Kind::half_space;
  shape.point = point;
  shape.normal = normal;
  return shape;
}

Shape of(Shape::Kind kind, std::vector<Shape> operands) {
  Shape shape;
  shape.kind = kind;
  shape.operands = std::move(operands);
  return shape;
}

template <int D>
double least_distance(const point_based::NodeCloud<D>& cloud) {
  const point_based::NearestNodes<D> nearest(cloud.positions);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& x : cloud.positions) least = std::min(least, nearest.nearest(x, 2)[1].distance);
  return least;
}

template <int D>
double volume_error_of_ball(double spacing) {
  const Shape ball = ball_at({0.03, 0.01, 0}, 1);
  const auto cloud = lattice_nodes<D>(ball, spacing);
  for (const auto& x : cloud.positions) {
    const double depth = -signed_distance(ball, padded<D>(x), D);
    EXPECT_GT(depth, -1e-6 * spacing);
    EXPECT_TRUE(depth < 1e-6 * spacing || depth > spacing / 4) << depth / spacing;
  }
  EXPECT_GT(least_distance(cloud), spacing / 2);
  const double exact = D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
  return std::abs(volume_of(cloud) / exact - 1);
}

// phi is linear along the edges of a cell: the error of the volume is at most h^2/8 times 3/R.
TEST(lattice_nodes, of_a_ball_lie_on_it_or_inside_and_have_its_volume_to_second_order) {
  EXPECT_LT(volume_error_of_ball<2>(0.1), 2 * 2 * 0.01 / 8);
  EXPECT_LT(volume_error_of_ball<3>(0.1), 2 * 3 * 0.01 / 8);
  EXPECT_LT(volume_error_of_ball<3>(0.05), 2 * 3 * 0.0025 / 8);
}

// A strain proportional to the distance from the middle, as in torsion: the sum of its square over
// the nodes is the polar moment of area, minus the second moments of the cells about their own
// nodes.
TEST(lattice_nodes, of_a_disc_have_its_second_moment) {
  for (const double spacing : {0.25, 0.2, 0.1}) {
    const auto cloud = lattice_nodes<2>(ball_at({0, 0, 0}, 1), spacing);
    double moment = 0;
    for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
      const auto& x = cloud.positions[i];
      moment += cloud.volumes[i] * (x[0] * x[0] + x[1] * x[1]);
    }
    EXPECT_NEAR(moment / (std::numbers::pi / 2), 1, 1.5 * spacing * spacing + 0.5 * spacing);
  }
}

// There are nodes on the corners and on the sides. No lattice point need be within half of the
// pitch of both sides of a corner.
TEST(lattice_nodes, of_a_turned_square_lie_on_its_corners) {
  for (const double angle : {0.35, 0.5, std::numbers::pi / 6, std::numbers::pi / 4}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Shape square = of(Shape::Kind::intersect,
                            {half_space({c, s, 0}, {c, s, 0}), half_space({-c, -s, 0}, {-c, -s, 0}),
                             half_space({-s, c, 0}, {-s, c, 0}), half_space({s, -c, 0}, {s, -c, 0}),
                             box({-c - s, -c - s, 0}, {c + s, c + s, 0})});
    for (const double spacing : {0.25, 2. / 7, 0.2}) {
      const auto cloud = lattice_nodes<2>(square, spacing);
      EXPECT_NEAR(volume_of(cloud), 4, 1e-3);
      const point_based::NearestNodes<2> nearest(cloud.positions);
      for (const double along : {-1., 1.}) {
        for (const double across : {-1., 1.}) {
          const Point<2> corner = {along * c - across * s, along * s + across * c};
          EXPECT_LT(nearest.nearest(corner, 1)[0].distance, 1e-6)
              << angle << ' ' << spacing << ' ' << along << ' ' << across;
        }
      }
    }
  }
}

// The layers of a round rod are equal, including those at its ends.
TEST(lattice_nodes, of_a_rod_stand_in_columns) {
  Shape round = ball_at({0, 0, 0}, 1);
  round.kind = Shape::Kind::cylinder;
  const Shape rod = of(Shape::Kind::intersect, {round, box({-2, -2, 0}, {2, 2, 1})});
  const auto cloud = lattice_nodes<3>(rod, 0.25);
  EXPECT_EQ(cloud.positions.size() % 5, 0);
  EXPECT_NEAR(volume_of(cloud), std::numbers::pi, 0.005);
  for (const auto& x : cloud.positions) {
    EXPECT_NEAR(4 * x[2], std::round(4 * x[2]), 1e-5);
  }
}

// Both nodes are within half a pitch of the wall.
TEST(lattice_nodes, two_on_both_sides_of_a_wall_do_not_meet_on_it) {
  BoundaryCase wall;
  wall.kind = BoundaryCase::Kind::fixed;
  wall.geometry.kind = Shape::Kind::half_space;
  wall.geometry.normal = {1, 0, 0};
  const Boundaries<2> boundaries(std::vector<BoundaryCase>{wall});
  point_based::NodeCloud<2> cloud;
  cloud.positions = {{-0.35, 0.01}, {0.25, 0}, {1, 0}};
  cloud.volumes = {1, 1, 1};
  point_based::fit_to_walls<2>(boundaries, box({-9, -9, 0}, {9, 9, 0}), Point<2>{1, 1}, cloud);
  EXPECT_EQ(cloud.positions[0], (Point<2>{-0.35, 0.01}));
  EXPECT_EQ(cloud.positions[1], (Point<2>{0, 0}));
}

}  // namespace
}  // namespace pliant::test
