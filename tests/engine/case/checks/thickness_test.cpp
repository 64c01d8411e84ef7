#include "engine/case/checks/thickness.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

// Thicknesses of shapes whose largest inscribed ball is known.
namespace pliant {
namespace {

double thickness_of(const std::string& geometry, const std::string& added = "",
                    const std::string& dimension = "2") {
  const Case a_case = tests::read_text(fmt::format(
      "dimension = {}\n[discretisation]\nspacing = 0.1\n[time]\nend = 1\n[[body]]\nname = \"it\"\n"
      "geometry = {{ {} }}\nmaterial = {{ model = \"linear\", youngs_modulus = 1, "
      "poissons_ratio = 0.3, density = 1 }}\n{}",
      dimension, geometry, added));
  return thickness(a_case, a_case.bodies[0]);
}

const std::string plate = "shape = \"box\", lower = [0, 0], upper = [30, 1.3]";

std::string wall(const std::string& name, const std::string& point, const std::string& normal) {
  return fmt::format(
      "[[boundary]]\nname = \"{}\"\nkind = \"slip_wall\"\ngeometry = {{ shape = \"half_space\", "
      "point = {}, normal = {} }}\n",
      name, point, normal);
}

TEST(thickness, is_the_diameter_of_the_largest_inscribed_ball) {
  EXPECT_NEAR(thickness_of(plate), 1.3, 1e-3);
  EXPECT_NEAR(thickness_of("shape = \"disc\", centre = [1, 2], radius = 0.7"), 1.4, 1e-3);
  EXPECT_NEAR(thickness_of("shape = \"difference\", of = [{ shape = \"disc\", centre = [0, 0], "
                           "radius = 4 }, { shape = \"disc\", centre = [0, 0], radius = 3.9 }]"),
              0.1, 1e-3);
  EXPECT_NEAR(
      thickness_of("shape = \"box\", lower = [0, -1, -0.25], upper = [10, 1, 0.25]", "", "3"), 0.5,
      1e-3);
}

TEST(thickness, is_that_between_free_surfaces) {
  const std::string sides = wall("left", "[0, 0]", "[1, 0]") + wall("right", "[30, 0]", "[-1, 0]"),
                    faces =
                        wall("lower", "[0, 0]", "[0, 1]") + wall("upper", "[0, 1.3]", "[0, -1]");
  EXPECT_NEAR(thickness_of(plate, sides), 1.3, 1e-3);
  EXPECT_NEAR(thickness_of(plate, faces), 30, 1e-2);
  EXPECT_TRUE(std::isinf(thickness_of(plate, sides + faces)));
  // One face is free: the touching ball may have any size.
  EXPECT_TRUE(std::isinf(thickness_of(plate, sides + wall("floor", "[0, 0]", "[0, 1]"))));
}

TEST(opening, is_the_diameter_of_the_hole_that_walls_leave) {
  const Case a_case = read_case(PLIANT_SOURCE_DIR "/cases/liver_aspiration");
  EXPECT_NEAR(opening(a_case, a_case.bodies[0]), 0.01, 1e-5);
  constexpr ThinBodyError errors[] = {{6, "much"}};
  std::vector<std::string> warnings;
  warn_of_narrow_openings(a_case, errors, warnings);
  EXPECT_TRUE(warnings.empty());
  const std::vector<std::string> settings = {"discretisation.spacing=0.025/14"};
  const Case coarse = read_case(PLIANT_SOURCE_DIR "/cases/liver_aspiration", settings);
  warn_of_narrow_openings(coarse, errors, warnings);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0],
            "the surface that walls leave free on body `tissue` is 5.6 spacings across: "
            "much; use a finer spacing (discretisation.spacing = 0.00167 or below)");
}

TEST(opening, has_no_end_without_walls_that_hold_the_body) {
  const Case a_case = tests::read_text(tests::block_case);
  EXPECT_TRUE(std::isinf(opening(a_case, a_case.bodies[0])));
}

TEST(thickness, only_bodies_below_the_number_are_warned_of_by_their_worst) {
  const Case a_case = tests::read_text(tests::block_case);  // 1 x 2 with a spacing of 0.1
  constexpr ThinBodyError errors[] = {{4, "much"}, {11, "a little"}};
  std::vector<std::string> warnings;
  warn_of_thin_bodies(a_case, errors, warnings);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0],
            "body `block` is 10 spacings thick: a little; use a finer spacing "
            "(discretisation.spacing = 0.0909 or below)");
  warn_of_thin_bodies(a_case, std::span(errors, 1), warnings);
  constexpr ThinBodyError as_thick[] = {{10, "a little"}};
  warn_of_thin_bodies(a_case, as_thick, warnings);
  EXPECT_EQ(warnings.size(), 1) << "neither of a thicker nor of an equally thick body";
}

// The ball of docs/equations.md, (TL.34), 8 spacings across.
TEST(thickness, slender_bodies_are_warned_of_by_their_deviation) {
  const Case a_case = tests::read_text(tests::block_case);  // L h/t^2 = 0.2
  std::vector<std::string> warnings;
  warn_of_slender_bodies(a_case, 0.49, warnings);
  EXPECT_TRUE(warnings.empty()) << "0.0196";
  warn_of_slender_bodies(a_case, 2, warnings);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0],
            "body `block` is 2 times as long as thick: loads bend it up to 8 % too little, more "
            "where they also compress it; use a finer spacing (discretisation.spacing = 0.05 or "
            "below) or method = \"total_lagrangian\"");
}

TEST(thickness, round_walls_are_warned_of_by_their_deviation) {
  Case a_case = tests::read_text(tests::block_case);  // h = 0.1
  BoundaryCase& core = a_case.boundaries.emplace_back();
  core.name = "core";
  core.kind = BoundaryCase::Kind::fixed;
  Shape& wall = core.geometry;
  wall.kind = Shape::Kind::ball;
  wall.radius = 0.5;
  std::vector<std::string> warnings;
  warn_of_round_walls(a_case, {.cylinder = 0.9, .ball = 2}, warnings);
  EXPECT_TRUE(warnings.empty()) << "0.036";
  Shape around;
  around.kind = Shape::Kind::subtract;
  around.operands = {Shape{}, wall};
  wall = around;
  warn_of_round_walls(a_case, {.cylinder = 4, .ball = 2}, warnings);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0],
            "the wall `core` is round, and its radius is small: a body that it holds turns up to "
            "16 % too "
            "far about it, and moves up to 8 % too far; use a finer spacing "
            "(discretisation.spacing = 0.05 or below) or method = \"total_lagrangian\"");
  core.kind = BoundaryCase::Kind::slip_wall;
  warn_of_round_walls(a_case, {.cylinder = 4, .ball = 2}, warnings);
  EXPECT_EQ(warnings.size(), 1);
}

TEST(thickness, bodies_are_as_long_as_what_half_spaces_leave_of_a_box) {
  Case cut = tests::read_text(tests::block_case);
  Shape& shape = cut.bodies[0].geometry;
  Shape around = shape;
  for (int a = 0; a < 2; ++a) {
    around.lower[a] -= 20;
    around.upper[a] += 20;
  }
  Shape both;
  both.kind = Shape::Kind::intersect;
  both.operands = {around, shape};
  shape = both;
  std::vector<std::string> warnings;
  warn_of_slender_bodies(cut, 0.49, warnings);
  EXPECT_TRUE(warnings.empty());
}

TEST(thickness, bodies_with_reentrant_corners_are_warned_of) {
  Case a_case = tests::read_text(tests::block_case);  // 1 x 2
  std::vector<std::string> warnings;
  warn_of_reentrant_corners(a_case, "too far", warnings);
  EXPECT_TRUE(warnings.empty());
  Shape& shape = a_case.bodies[0].geometry;
  Shape notch = shape, both;
  notch.lower[0] = (shape.lower[0] + shape.upper[0]) / 2;
  notch.lower[1] = (shape.lower[1] + shape.upper[1]) / 2;
  notch.upper[0] += 1;
  notch.upper[1] += 1;
  both.kind = Shape::Kind::subtract;
  both.operands = {shape, notch};
  shape = both;
  warn_of_reentrant_corners(a_case, "too far", warnings);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0],
            "body `block` has a re-entrant corner, such as that of an L or of a notch: too far; "
            "take method = \"total_lagrangian\" for bodies that keep their neighbours");
}

}  // namespace
}  // namespace pliant
