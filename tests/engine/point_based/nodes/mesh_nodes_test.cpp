#include "engine/point_based/nodes/mesh_nodes.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace pliant::point_based {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.);
}

TEST(mesh_nodes, volumes_sum_to_that_of_the_mesh_and_follow_the_scale) {
  VolumeMesh mesh;
  mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.elements = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  const double volumes[] = {0.5, element_volume(mesh, 1)};
  const NodeCloud<3> cloud = nodes_of_mesh<3>(mesh, 0.1, {1, 2, 3});
  EXPECT_NEAR(sum(cloud.volumes), 1e-3 * (volumes[0] + volumes[1]), 1e-18);
  EXPECT_NEAR(cloud.volumes[0], 1e-3 * volumes[0] / 4, 1e-18);
  EXPECT_NEAR(cloud.volumes[4], 1e-3 * volumes[1] / 4, 1e-18);
  EXPECT_DOUBLE_EQ(cloud.positions[1][0], 1.3);
  EXPECT_DOUBLE_EQ(cloud.positions[1][1], 2);
  EXPECT_EQ(cloud.elements.size(), 2u);
}

TEST(mesh_nodes, a_triangle_gives_a_third_to_each_corner) {
  const VolumeMesh mesh{2, {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2, -1}}};
  const NodeCloud<2> cloud = nodes_of_mesh<2>(mesh, 1, {});
  for (const double volume : cloud.volumes) EXPECT_DOUBLE_EQ(volume, 1. / 3);
}

}  // namespace
}  // namespace pliant::point_based
