#include <gtest/gtest.h>

#include <cmath>

#include "engine/remeshed/observe/particle_values.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

/// A block under a collar: a wall that covers its top except for a hole of 0.4 m around x = 0. The
/// surface is free in the hole; the level set continues through the collar.
const std::string collared_block = R"(
[discretisation]
spacing = 0.05
[time]
end = 1
[[body]]
name = "block"
geometry = { shape = "box", lower = [-0.5, 0], upper = [0.5, 1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "collar"
kind = "fixed"
geometry = { shape = "difference", of = [
  { shape = "half_space", point = [0, 1], normal = [0, -1] },
  { shape = "box", lower = [-0.2, -inf], upper = [0.2, inf] } ] }
[[measurement]]
name = "top"
kind = "extent"
axis = "y"
[[measurement]]
name = "in_the_hole"
kind = "surface_distance"
point = [0, 0.5]
direction = [0, 1]
[[measurement]]
name = "under_the_collar"
kind = "surface_distance"
point = [0.35, 0.5]
direction = [0, 1]
[[measurement]]
name = "inside"
kind = "point_value"
field = "density"
point = [0.1, 0.5]
[[measurement]]
name = "beside"
kind = "point_value"
field = "density"
point = [0.52, 0.5]
[[measurement]]
name = "in_the_collar"
kind = "point_value"
field = "density"
point = [0.35, 1.02]
)";

TEST(measuring, surfaces_end_where_a_body_is_attached_to_a_wall) {
  Solver solver(tests::read_text(collared_block), {1, kernels::Isa::sse2});
  const std::vector<double> values = solver.measure();
  EXPECT_NEAR(values[0], 1, 0.01 * 0.05);
  EXPECT_NEAR(values[1], 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(values[2])) << "the line ends at the wall";
}

// Beside the edges of a box phi has a kink along the node lines that cross its faces: a cubic
// through it would end 0.06 spacings outside.
TEST(measuring, the_extent_of_a_box_ends_at_its_faces) {
  for (const int dimension : {2, 3}) {
    for (const std::string spacing : {"0.2", "0.125", "0.077"}) {
      const bool plane = dimension == 2;
      const Case settings = tests::read_text(
          tests::rubber_case("remeshed", dimension, spacing, "1") +
          "[[body]]\nname = \"box\"\nmaterial = \"rubber\"\ngeometry = { shape = \"box\", lower "
          "= " +
          (plane ? "[0, 0]" : "[0, 0, 0]") + ", upper = " + (plane ? "[1, 2]" : "[1, 2, 1]") +
          " }\n[[measurement]]\nname = \"x\"\nkind = \"extent\"\n"
          "[[measurement]]\nname = \"y\"\nkind = \"extent\"\naxis = \"y\"\nside = \"lower\"\n");
      const std::vector<double> found = methods().make(settings, {})->measure();
      EXPECT_NEAR(found[0], 1, 1e-4) << dimension << ' ' << spacing;
      EXPECT_NEAR(found[1], 0, 1e-9) << dimension << ' ' << spacing;
    }
  }
}

TEST(measuring, fields_have_no_value_outside_the_body) {
  Solver solver(tests::read_text(collared_block), {1, kernels::Isa::sse2});
  const std::vector<double> values = solver.measure();
  EXPECT_NEAR(values[3], 1, 1e-12);
  EXPECT_TRUE(std::isnan(values[4]));
  EXPECT_TRUE(std::isnan(values[5]));
}

TEST(measuring, displacements_have_no_value_where_no_particles_started) {
  Solver solver(tests::read_text(collared_block), {1, kernels::Isa::sse2});
  const Body& body = solver.state().bodies[0];
  EXPECT_EQ((remeshed::material_value<double, 2>(body, {0.1, 0.5, 0}, "displacement_x")), 0);
  EXPECT_TRUE(std::isnan(remeshed::material_value<double, 2>(body, {5, 5, 0}, "displacement_x")));
}

}  // namespace
}  // namespace pliant::test
