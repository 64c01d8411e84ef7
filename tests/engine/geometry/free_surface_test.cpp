#include "engine/geometry/free_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/signed_distance.hpp"
#include "tests/engine/geometry/meshes.hpp"
#include "tests/engine/geometry/shapes.hpp"

namespace pliant {
namespace {

using namespace tests;

const Shape block = box({-0.5, -1, 0}, {0.5, 1, 0});

/// Distance from the free surface of a plane body; minus infinity if it has none.
double distance(const Shape& body, const std::vector<Shape>& walls, const Vector& x) {
  return signed_distance(free_surface(body, walls, 2), x, 2);
}

TEST(free_surface, a_body_without_walls_keeps_its_distance) {
  EXPECT_EQ(distance(block, {}, {0, 0.9, 0}), -0.09999999999999998);
}

TEST(free_surface, it_continues_through_attached_half_spaces) {
  const std::vector<Shape> pistons{half_space({0, 1, 0}, {0, -1, 0}),
                                   half_space({0, -1, 0}, {0, 1, 0})};
  for (const double y : {-3.0, -1.0, -0.99, 0.0, 0.5, 1.0, 2.0}) {
    for (const double x : {-0.7, -0.5, 0.0, 0.3, 1.5}) {
      EXPECT_EQ(distance(block, pistons, {x, y, 0}), std::abs(x) - 0.5);
    }
  }
}

TEST(free_surface, a_wall_elsewhere_changes_nothing) {
  const std::vector<Shape> walls{half_space({0, 1.1, 0}, {0, -1, 0}),  // away from the face
                                 half_space({0, 1, 0}, {0, 1, 0}),     // the body is inside it
                                 half_space({0, -1, 0}, {0.6, 0.8, 0}),
                                 box({3, 1, 0}, {4, 2, 0}),  // beside the face
                                 ball({0, 2, 0}, 1)};
  const Shape open = free_surface(block, walls, 2);
  EXPECT_EQ(open.lower, block.lower);
  EXPECT_EQ(open.upper, block.upper);
}

TEST(free_surface, it_continues_through_a_box_that_covers_the_face) {
  const std::vector<Shape> walls{box({-0.5, 1, 0}, {0.5, 1.2, 0})};
  const Shape open = free_surface(block, walls, 2);
  EXPECT_EQ(open.upper, (Vector{0.5, infinity, 0}));
  EXPECT_EQ(open.lower, block.lower);
}

TEST(free_surface, a_box_that_covers_half_a_face_opens_that_half) {
  const std::vector<Shape> walls{box({0, 1, 0}, {2, 1.2, 0})};
  EXPECT_EQ(distance(block, walls, {0.25, 1, 0}), -0.25);
  EXPECT_EQ(distance(block, walls, {0.25, 7, 0}), -0.25);
  EXPECT_EQ(distance(block, walls, {-0.25, 1.125, 0}), 0.125);
}

TEST(free_surface, planes_match_to_rounding) {
  const std::vector<Shape> walls{half_space({0, 0.1 + 0.2, 0}, {0, -1, 0})};
  const Shape open = free_surface(box({0, 0, 0}, {1, 0.3, 0}), walls, 2);
  EXPECT_EQ(open.upper[1], infinity);
}

// A gap of less than half a spacing, or a face inside the wall, is no free surface.
TEST(free_surface, faces_near_walls_and_inside_them_are_open) {
  for (const double place : {1.04, 0.9, 0.2}) {
    const std::vector<Shape> wall{half_space({0, place, 0}, {0, -1, 0})};
    EXPECT_EQ(free_surface(block, wall, 2, 0.05).upper[1], infinity) << place;
    const Shape cut = combine(Shape::Kind::intersect,
                              {half_space({0, 1, 0}, {0, 1, 0}), box({-0.5, -1, 0}, {0.5, 9, 0})});
    EXPECT_EQ(free_surface(cut, wall, 2, 0.05).upper[1], infinity) << place;
  }
  const std::vector<Shape> far{half_space({0, 1.06, 0}, {0, -1, 0})};
  EXPECT_EQ(free_surface(block, far, 2, 0.05).upper[1], 1);
  const std::vector<Shape> core{box({-0.5, 0.4, 0}, {0.5, 0.6, 0})};
  EXPECT_EQ(free_surface(block, core, 2, 0.05).upper[1], 1);
}

// The notch touches the wall, so it too continues through the wall.
TEST(free_surface, parts_of_a_combination_are_opened_alike) {
  const Shape notched = combine(Shape::Kind::subtract, {block, box({-0.1, 0.5, 0}, {0.1, 1, 0})});
  const std::vector<Shape> walls{half_space({0, 1, 0}, {0, -1, 0})};
  EXPECT_DOUBLE_EQ(distance(notched, walls, {0, 3, 0}), 0.1);
  EXPECT_DOUBLE_EQ(distance(notched, walls, {0.3, 3, 0}), -0.2);
}

// A disc, or a part of it between planes of symmetry: with walls in these planes, the disc is
// whole.
TEST(free_surface, half_spaces_that_cut_a_body_at_walls_cut_nothing_off) {
  const Shape disc = ball({0, 0, 0}, 1);
  const Vector oblique = {0.6, 0.8, 0}, back = {-0.6, -0.8, 0};
  const std::vector<Shape> walls{half_space({0.8, -0.6, 0}, oblique)};
  const Shape kept = combine(Shape::Kind::intersect, {disc, half_space({0, 0, 0}, back)});
  const Shape left = combine(Shape::Kind::subtract, {disc, half_space({0, 0, 0}, oblique)});
  for (const Shape& half : {kept, left}) {
    for (const Vector& x : {Vector{0.1, 0.1, 0}, Vector{-0.3, -0.4, 0}, Vector{2, 0, 0}}) {
      EXPECT_EQ(distance(half, walls, x), signed_distance(disc, x, 2));
    }
    // A wall in another plane, or one with the body on its other side, changes nothing.
    for (const Shape& wall : {half_space({-0.1, 0, 0}, oblique), half_space({0, 0, 0}, back)}) {
      const Vector x = {-0.3, -0.4, 0};
      EXPECT_EQ(distance(half, {wall}, x), signed_distance(half, x, 2));
    }
  }
}

// A box of triangles in the corner between two walls: nearer to the corner than its height, the
// free surface is that of the box whose sides continue through both walls.
TEST(free_surface, a_mesh_runs_on_through_walls_on_which_its_flat_sides_lie) {
  const Shape mesh = mesh_shape(box_mesh({0, 0, 0}, {1, 2, 3}));
  const std::vector<Shape> walls{half_space({0, 0, 0}, {1, 0, 0}), box({-1, -1, -1}, {1, 2, 0})};
  const Shape open = free_surface(mesh, walls, 3);
  const Shape exact = box({-infinity, 0, -infinity}, {1, 2, 3});
  for (const Vector& x : {Vector{0.1, 1, 0.2}, Vector{0, 0.3, 0}, Vector{-0.4, 0.6, -0.5},
                          Vector{0.5, 2.25, 0.1}, Vector{1.5, 0.5, -0.5}}) {
    EXPECT_NEAR(signed_distance(open, x, 3), signed_distance(exact, x, 3), 1e-14);
  }
}

// The side is at z = 0.
TEST(free_surface, a_mesh_runs_on_through_walls_that_it_crosses_or_nearly_reaches) {
  const Shape mesh = mesh_shape(box_mesh({0, 0, 0}, {1, 2, 3}));
  for (const double place : {0.5, -0.04}) {
    const std::vector<Shape> wall{half_space({0, 0, place}, {0, 0, 1})};
    const Shape open = free_surface(mesh, wall, 3, 0.05);
    EXPECT_NEAR(signed_distance(open, {0.1, 1, -1}, 3), -0.1, 1e-14) << place;
  }
}

// Walls that it does not reach, or that do not cover its side.
TEST(free_surface, a_mesh_without_a_flat_side_on_a_wall_keeps_its_surface) {
  const Shape mesh = mesh_shape(box_mesh({0, 0, 0}, {1, 2, 3}));
  const std::vector<Shape> walls{half_space({0, 0, -0.1}, {0, 0, 1}),
                                 half_space({0, 0, 0}, {0, 0.6, 0.8}),
                                 box({0.5, -1, -1}, {2, 3, 0}), ball({0, 0, -1}, 1)};
  EXPECT_EQ(free_surface(mesh, walls, 3).mesh, mesh.mesh);
}

}  // namespace
}  // namespace pliant
