#include "engine/geometry/closed_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "engine/geometry/signed_distance.hpp"
#include "tests/engine/geometry/meshes.hpp"
#include "tests/engine/geometry/shapes.hpp"

namespace pliant {
namespace {

using namespace tests;

const Vector lower = {-1, -2, -3}, upper = {1.5, 0.5, 1};

// For the box the distance is known exactly. Half of these points are nearest to an edge or a
// corner.
TEST(closed_mesh, the_distance_to_a_box_of_triangles_is_that_to_the_box) {
  const ClosedMesh mesh(box_mesh(lower, upper), "box");
  const Shape exact = box(lower, upper);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-5, 4);
  for (int k = 0; k < 20000; ++k) {
    const Vector x = {place(random), place(random), place(random)};
    const ClosedMesh::Nearest found = mesh.nearest(x);
    ASSERT_NEAR(found.distance, signed_distance(exact, x, 3), 1e-14);
    const Vector direction = outward_direction(exact, x, 3);
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(found.direction[i], direction[i], 1e-12);
  }
}

// Points straight out from corners, edges and diagonals, where several triangles are equally near.
TEST(closed_mesh, signs_hold_where_triangles_meet) {
  const ClosedMesh mesh(box_mesh({-1, -1, -1}, {1, 1, 1}), "cube");
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x == 0 && y == 0 && z == 0) continue;
        const double corners = std::abs(x) + std::abs(y) + std::abs(z);
        EXPECT_NEAR(mesh.nearest({1.1 * x, 1.1 * y, 1.1 * z}).distance, 0.1 * std::sqrt(corners),
                    1e-15);
        EXPECT_NEAR(mesh.nearest({0.9 * x, 0.9 * y, 0.9 * z}).distance, -0.1, 1e-15);
        EXPECT_EQ(mesh.nearest({x, y, z}).distance, 0);
      }
    }
  }
}

/// A star of spikes: a sphere whose vertices have three different radii in turn. On the ray through
/// a vertex, points below it are inside and points above it outside, whatever other spikes are
/// near.
TEST(closed_mesh, signs_hold_at_the_tips_and_in_the_pits_of_a_star) {
  SurfaceMesh star = sphere_mesh(1, 3);
  for (std::size_t v = 0; v < star.vertices.size(); ++v) {
    for (double& component : star.vertices[v]) component *= v % 3 == 0 ? 2 : v % 3 == 1 ? 0.7 : 1.1;
  }
  const std::vector<Vector> tips = star.vertices;
  const ClosedMesh mesh(star, "star");
  for (const Vector& tip : tips) {
    for (const double factor : {0.01, 0.5, 0.9, 0.9999, 1.0001, 1.1, 3.0}) {
      const double distance =
          mesh.nearest({factor * tip[0], factor * tip[1], factor * tip[2]}).distance;
      EXPECT_EQ(distance < 0, factor < 1) << factor;
    }
  }
}

TEST(closed_mesh, the_nearest_triangle_is_the_nearest_of_all) {
  const SurfaceMesh sphere = sphere_mesh(1, 4);
  const ClosedMesh mesh(sphere, "sphere");
  // Every point of the surface has a radius between that of the inscribed sphere and 1.
  double inscribed = 1;
  for (const Triangle& t : sphere.triangles) {
    Vector centre;
    for (int i = 0; i < 3; ++i) {
      centre[i] =
          (sphere.vertices[t[0]][i] + sphere.vertices[t[1]][i] + sphere.vertices[t[2]][i]) / 3;
    }
    inscribed = std::min(inscribed, std::hypot(centre[0], centre[1], centre[2]));
  }
  std::mt19937 random(2);
  std::normal_distribution<double> place(0, 0.7);
  for (int k = 0; k < 5000; ++k) {
    const Vector x = {place(random), place(random), place(random)};
    const double radius = std::hypot(x[0], x[1], x[2]);
    const double distance = mesh.nearest(x).distance;
    ASSERT_GE(distance, radius - 1 - 1e-12);
    ASSERT_LE(distance, radius - inscribed + 1e-12);
  }
}

TEST(closed_mesh, volume_and_bounds_are_those_of_the_solid) {
  const ClosedMesh mesh(box_mesh(lower, upper), "box");
  EXPECT_DOUBLE_EQ(mesh.volume(), 2.5 * 2.5 * 4);
  EXPECT_EQ(mesh.bounds().lower, lower);
  EXPECT_EQ(mesh.bounds().upper, upper);
  // 4^5 * 8 triangles inscribed in the sphere: the error is about a squared edge over the radius.
  EXPECT_NEAR(ClosedMesh(sphere_mesh(1, 5), "sphere").volume(), 4 * std::numbers::pi / 3, 0.01);
}

TEST(closed_mesh, a_surface_that_faces_inwards_is_turned) {
  SurfaceMesh inwards = box_mesh(lower, upper);
  for (Triangle& t : inwards.triangles) std::swap(t[0], t[1]);
  const ClosedMesh mesh(inwards, "box");
  EXPECT_DOUBLE_EQ(mesh.volume(), 25);
  EXPECT_DOUBLE_EQ(mesh.nearest({0, 0, 0}).distance, -0.5);
}

TEST(closed_mesh, corners_of_their_own_are_joined_and_triangles_without_area_dropped) {
  const SurfaceMesh shared = box_mesh(lower, upper);
  SurfaceMesh soup;
  for (const Triangle& t : shared.triangles) {
    const auto first = static_cast<std::int32_t>(soup.vertices.size());
    for (const std::int32_t v : t) soup.vertices.push_back(shared.vertices[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  soup.triangles.push_back({0, 0, 1});
  soup.vertices.push_back({0, 0, 0});  // used by no triangle
  const ClosedMesh mesh(soup, "soup");
  EXPECT_EQ(mesh.vertices().size(), 8u);
  EXPECT_EQ(mesh.triangles().size(), 12u);
  EXPECT_EQ(mesh.dropped(), 1u);
}

std::string refusal(SurfaceMesh mesh) {
  try {
    const ClosedMesh closed(std::move(mesh), "m.stl");
  } catch (const MeshError& error) {
    return std::string(error.what()) + "; " + error.remedy();
  }
  return "";
}

TEST(closed_mesh, an_open_surface_is_refused_with_its_first_gap) {
  SurfaceMesh open = box_mesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_EQ(refusal(open),
            "m.stl: open edges: 3, the first near (1, 0.5, 0.5); close the surface, and give "
            "points that touch the same place");
}

TEST(closed_mesh, an_edge_of_many_triangles_is_refused) {
  SurfaceMesh crowded = box_mesh({0, 0, 0}, {1, 1, 1});
  const SurfaceMesh other = box_mesh({1, 1, 0}, {2, 2, 1});  // the two boxes share an edge
  for (const Triangle& t : other.triangles) {
    crowded.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  }
  crowded.vertices.insert(crowded.vertices.end(), other.vertices.begin(), other.vertices.end());
  EXPECT_EQ(refusal(crowded),
            "m.stl: edges of more than two triangles: 1, the first near (1, 1, 0.5); remove "
            "double and inner triangles, so that the surface has one inside");
}

TEST(closed_mesh, a_triangle_that_faces_the_other_way_is_refused) {
  SurfaceMesh turned = box_mesh({0, 0, 0}, {1, 1, 1});
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_EQ(refusal(turned),
            "m.stl: edges between triangles that face different ways: 3, the first near (0, "
            "0.5, 0); orient all faces outwards");
}

}  // namespace
}  // namespace pliant
