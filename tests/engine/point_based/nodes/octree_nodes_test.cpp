#include "engine/point_based/nodes/octree_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/geometry/signed_distance.hpp"
#include "engine/point_based/nodes/lattice_nodes.hpp"
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
  // Distances of meshes are linear between lattice points, with (TL.33). Without it a ball of four
  // spacings lacks 3 %.
  const Shape mesh = tests::mesh_shape(tests::sphere_mesh(1, 4));
  EXPECT_NEAR(sum(octree_nodes<3>(mesh, {0.2, 0.8})), sum(lattice_nodes<3>(mesh, 0.2)), 1e-12);
  for (const double spacing : {0.25, 0.2, 0.1}) {
    EXPECT_NEAR(sum(octree_nodes<3>(mesh, {spacing, 0.8})), mesh.mesh->volume(), 0.003 * volume);
  }
}

TEST(octree_nodes, of_one_size_are_those_of_the_lattice) {
  for (const Shape& shape : {tests::box({0, 0, 0}, {1, 0.5, 0.6}), tests::ball({0, 0, 0}, 0.8)}) {
    const NodeCloud<3> octree = octree_nodes<3>(shape, {0.125, 0.125});
    const NodeCloud<3> lattice = lattice_nodes<3>(shape, 0.125);
    EXPECT_EQ(octree.positions, lattice.positions);
    EXPECT_EQ(octree.volumes, lattice.volumes);
  }
}

TEST(octree_nodes, lie_on_the_surface_are_dense_there_and_coarse_within) {
  const Shape ball = tests::ball({0, 0, 0}, 1);
  const NodeCloud<3> cloud = octree_nodes<3>(ball, {0.05, 0.4});
  double largest = 0;
  std::size_t on_surface = 0;
  for (std::size_t i = 0; i < cloud.volumes.size(); ++i) {
    const double d = signed_distance(ball, position(cloud, i), 3),
                 side = std::cbrt(cloud.volumes[i]);
    EXPECT_LT(d, 1e-6);
    EXPECT_LE(side, 0.05 - 0.5 * d + 0.04);
    if (d > -1e-6) ++on_surface;
    largest = std::max(largest, side);
  }
  EXPECT_GT(largest, 0.2);
  EXPECT_NEAR(static_cast<double>(on_surface), 4 * pi / (0.05 * 0.05),
              0.2 * 4 * pi / (0.05 * 0.05));
  // A lattice of the finest size would have 33510 nodes.
  EXPECT_LT(cloud.volumes.size(), 17000u);
}

// The sizes of cells follow from the distance to the plane y = 0 of a cut, or to the surface.
TEST(octree_nodes, are_dense_around_cuts) {
  const Shape box = tests::box({-1, -1, 0}, {1, 1, 0});
  std::vector<Point<2>> cut;
  for (double x = -1; x <= 0; x += 0.02) cut.push_back({x, 0.013});
  const NodeCloud<2> cloud = octree_nodes<2>(box, {0.05, 0.4}, cut);
  double largest = 0;
  for (std::size_t i = 0; i < cloud.volumes.size(); ++i) {
    const Point<2>& x = cloud.positions[i];
    const double side = std::sqrt(cloud.volumes[i]),
                 from_cut = std::hypot(std::max(x[0], 0.), x[1] - 0.013);
    if (from_cut < 0.05) {
      EXPECT_LT(side, 0.051);
    }
    EXPECT_LE(side, 0.05 + 0.5 * from_cut + 0.04);
    largest = std::max(largest, side);
  }
  EXPECT_GT(largest, 0.15);
  EXPECT_NEAR(sum(cloud), 4, 1e-9);
  EXPECT_GT(cloud.volumes.size(), octree_nodes<2>(box, {0.05, 0.4}).volumes.size());
}

}  // namespace
}  // namespace pliant::point_based
