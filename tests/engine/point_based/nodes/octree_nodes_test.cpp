#include "engine/point_based/nodes/octree_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/geometry/signed_distance.hpp"
#include "tests/engine/geometry/meshes.hpp"
#include "tests/engine/geometry/shapes.hpp"

namespace pliant::point_based {
namespace {

using std::numbers::pi;

template <int D>
double sum(const NodeCloud<D>& cloud) {
  return std::accumulate(cloud.volumes.begin(), cloud.volumes.end(), 0.);
}

template <int D>
Vector position(const NodeCloud<D>& cloud, std::size_t i) {
  Vector x = {};
  std::copy_n(cloud.positions[i].begin(), D, x.begin());
  return x;
}

TEST(octree_nodes, volumes_sum_to_that_of_the_body) {
  const Shape ball = tests::ball({0.1, 0.2, 0.3}, 1);
  const double volume = 4 * pi / 3;
  // The sampled volume fractions of cut cells are of second order.
  EXPECT_NEAR(sum(octree_nodes<3>(ball, {0.2, 0.8})), volume, 0.004 * volume);
  EXPECT_NEAR(sum(octree_nodes<3>(ball, {0.1, 0.8})), volume, 0.001 * volume);
  EXPECT_NEAR(sum(octree_nodes<2>(ball, {0.05, 0.4})), pi, 0.001 * pi);
  const Shape mesh = tests::mesh_shape(tests::sphere_mesh(1, 3));
  EXPECT_NEAR(sum(octree_nodes<3>(mesh, {0.2, 0.8})), mesh.mesh->volume(), 0.004 * volume);
}

TEST(octree_nodes, a_box_of_whole_cells_has_them_exactly) {
  const NodeCloud<3> cloud = octree_nodes<3>(tests::box({0, 0, 0}, {1, 0.5, 0.5}), {0.125, 0.125});
  ASSERT_EQ(cloud.positions.size(), 8u * 4 * 4);
  for (const double volume : cloud.volumes) EXPECT_DOUBLE_EQ(volume, std::pow(0.125, 3));
  EXPECT_DOUBLE_EQ(cloud.positions[0][0], 0.0625);
}

TEST(octree_nodes, nodes_are_inside_dense_at_the_surface_and_coarse_within) {
  const Shape ball = tests::ball({0, 0, 0}, 1);
  const NodeCloud<3> cloud = octree_nodes<3>(ball, {0.05, 0.4});
  double largest = 0, smallest = 1;
  for (std::size_t i = 0; i < cloud.volumes.size(); ++i) {
    const double d = signed_distance(ball, position(cloud, i), 3),
                 side = std::cbrt(cloud.volumes[i]);
    EXPECT_LT(d, 0);
    EXPECT_LE(side, 0.05 - 0.5 * d + 0.04);  // with the volume that joined the leaf
    largest = std::max(largest, side);
    smallest = std::min(smallest, side);
  }
  EXPECT_DOUBLE_EQ(largest, 0.4);
  EXPECT_GE(smallest, 0.05 * std::cbrt(0.3) - 1e-12);
  // A lattice of the smallest size would have 33510 nodes.
  EXPECT_LT(cloud.volumes.size(), 15000u);
}

}  // namespace
}  // namespace pliant::point_based
