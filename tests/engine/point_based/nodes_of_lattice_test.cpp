#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/lattice_nodes.hpp"

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

// The lattice does not fit: what sticks out belongs to the nodes on the last layer.
TEST(lattice_nodes, of_a_box_between_lattice_points_have_its_volume) {
  const auto cloud = lattice_nodes<2>(box({0, 0, 0}, {1, 0.47, 0}), 0.1);
  EXPECT_NEAR(volume_of(cloud), 0.47, 1e-3);
}

template <int D>
double volume_error_of_ball(double spacing) {
  Shape ball;
  ball.kind = Shape::Kind::ball;
  ball.centre = {0.03, 0.01, 0};
  ball.radius = 1;
  const auto cloud = lattice_nodes<D>(ball, spacing);
  for (const auto& x : cloud.positions) EXPECT_LT(signed_distance(ball, padded<D>(x), D), 1e-9);
  const double exact = D == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
  return std::abs(volume_of(cloud) / exact - 1);
}

// phi is linear along the edges of a cell: the volume errs by its curvature, h^2/8 of 3/R at most.
TEST(lattice_nodes, of_a_ball_lie_inside_and_have_its_volume_to_second_order) {
  EXPECT_LT(volume_error_of_ball<2>(0.1), 2 * 2 * 0.01 / 8);
  EXPECT_LT(volume_error_of_ball<3>(0.1), 2 * 3 * 0.01 / 8);
  EXPECT_LT(volume_error_of_ball<3>(0.05), 2 * 3 * 0.0025 / 8);
}

}  // namespace
}  // namespace pliant::test
