#include "engine/case/reading/read_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/case/vocabulary/example.hpp"
#include "engine/case/writing/resolved.hpp"
#include "engine/method/initial_stress.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

using tests::block_case;
using tests::complaint;
using tests::read_text;
using tests::with;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(read_case, prony_series_gives_the_modulus_of_a_sudden_change) {
  for (const std::string moduli : {"long_term", "instantaneous"}) {
    const Case a_case = read_text(with(
        block_case,
        R"({ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 })",
        "{ model = \"reduced_polynomial\", coefficients = [1], compressibility = 0.1, density = "
        "1, prony = { ratios = [0.3, 0.2], times = [1, 10], moduli = \"" +
            moduli + "\" } }"));
    const BodyCase& body = a_case.bodies.at(0);
    EXPECT_DOUBLE_EQ(body.material.bulk_modulus, moduli == "long_term" ? 40 : 20);
    EXPECT_DOUBLE_EQ(2 / body.material.compressibility, body.material.bulk_modulus);
    ASSERT_EQ(body.prony.size(), 2u);
    EXPECT_EQ(body.prony[1].ratio, 0.2);
    EXPECT_EQ(body.prony[1].time, 10);
  }
}

TEST(read_case, what_a_file_does_not_say_has_its_default) {
  const Case a_case = read_text(block_case);
  EXPECT_EQ(a_case.name, "block");
  EXPECT_EQ(a_case.title, "a block");
  EXPECT_EQ(a_case.dimension, 2);
  EXPECT_EQ(a_case.discretisation.spacing, 0.1);
  EXPECT_EQ(a_case.discretisation.kernel, kernels::Kernel::compact);
  EXPECT_FALSE(a_case.time.step.has_value());
  EXPECT_EQ(a_case.remeshing.policy, decltype(a_case.remeshing)::Policy::adaptive);
  EXPECT_EQ(a_case.ghosts, GhostTreatment::linear);
  const auto& velocity = a_case.bodies.at(0).velocity.translation;
  EXPECT_EQ(velocity[0](1, 2, 3, 4), 0);
  EXPECT_TRUE(a_case.boundaries.empty());
}

// K = E/(3 (1 - 2 nu)) = 100/1.2, mu = E/(2 (1 + nu)) = 100/2.6, to rounding.
TEST(read_case, linear_moduli_follow_from_youngs_modulus) {
  const kernels::Material<double> material = read_text(block_case).bodies.at(0).material;
  EXPECT_EQ(material.model, kernels::Model::linear);
  EXPECT_EQ(material.density, 2);
  EXPECT_NEAR(material.bulk_modulus, 83.333333333333333, 1e-12);
  EXPECT_NEAR(material.shear_modulus, 38.461538461538462, 1e-12);
}

TEST(read_case, a_named_material_serves_several_bodies) {
  const Case a_case = read_text(R"(
[discretisation]
spacing = 0.1
[time]
end = 1
[material.soft]
model = "reduced_polynomial"
coefficients = [2.2, 0.5]
compressibility = 0.001
density = 1
[[body]]
name = "a"
geometry = { shape = "disc", centre = [0, 0], radius = 1 }
material = "soft"
[[body]]
name = "b"
geometry = { shape = "disc", centre = [3, 0], radius = 1 }
material = "soft"
)");
  ASSERT_EQ(a_case.bodies.size(), 2U);
  for (const BodyCase& body : a_case.bodies) {
    EXPECT_EQ(body.material.model, kernels::Model::reduced_polynomial);
    EXPECT_EQ(body.material.order, 2);
    EXPECT_EQ(body.material.coefficient, (std::array<double, 5>{2.2, 0.5, 0, 0, 0}));
    EXPECT_EQ(body.material.bulk_modulus, 2000);
    EXPECT_EQ(body.material.shear_modulus, 4.4);
    EXPECT_EQ(body.material.compressibility, 0.001);
  }
}

TEST(read_case, numbers_may_be_formulas_of_constants) {
  const Case a_case = read_text(with(block_case, "spacing = 0.1", "spacing = \"sqrt(pi/800)\""));
  EXPECT_DOUBLE_EQ(a_case.discretisation.spacing, std::sqrt(3.14159265358979323846 / 800));
}

TEST(read_case, shapes_nest) {
  const Case a_case = read_text(
      with(block_case, "{ shape = \"box\", lower = [0, 0], upper = [1, 2] }",
           R"({ shape = "difference", of = [{ shape = "box", lower = [0, 0], upper = [1, 2] }, )"
           "{ shape = \"disc\", centre = [0.5, 1], radius = 0.2 }, "
           "{ shape = \"half_space\", point = [0, 0.5], normal = [0, 2] }] }"));
  const Shape& shape = a_case.bodies.at(0).geometry;
  ASSERT_EQ(shape.kind, Shape::Kind::subtract);
  ASSERT_EQ(shape.operands.size(), 3U);
  EXPECT_EQ(shape.operands[0].upper, (Vector{1, 2, 0}));
  EXPECT_EQ(shape.operands[1].kind, Shape::Kind::ball);
  EXPECT_EQ(shape.operands[2].normal, (Vector{0, 1, 0}));
}

TEST(read_case, boundaries_keep_their_motion_and_pressure) {
  const Case a_case = read_text(block_case + R"toml(
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "lid"
kind = "moving_wall"
geometry = { shape = "box", lower = [-inf, 2], upper = [inf, inf] }
velocity = [0, "-3*t"]
[[boundary]]
name = "side"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[boundary]]
name = "air"
kind = "pressure"
geometry = { shape = "box", lower = [0.5, 0.2], upper = [2, 1.8] }
pressure = "10*(1 - exp(-t))"
)toml");
  ASSERT_EQ(a_case.boundaries.size(), 4U);
  EXPECT_EQ(a_case.boundaries[0].kind, BoundaryCase::Kind::fixed);
  EXPECT_EQ(a_case.boundaries[1].kind, BoundaryCase::Kind::moving_wall);
  EXPECT_EQ(a_case.boundaries[1].velocity[1](2), -6);
  EXPECT_EQ(a_case.boundaries[1].geometry.upper, (Vector{infinity, infinity, 0}));
  EXPECT_EQ(a_case.boundaries[2].kind, BoundaryCase::Kind::slip_wall);
  EXPECT_EQ(a_case.boundaries[3].kind, BoundaryCase::Kind::pressure);
  EXPECT_DOUBLE_EQ(a_case.boundaries[3].pressure(1), 10 * (1 - std::exp(-1.0)));
}

TEST(read_case, measurements_refer_by_name) {
  const Case a_case = read_text(block_case + R"(
[[measurement]]
name = "beat"
kind = "period"
of = "tip"
[[measurement]]
name = "tip"
kind = "point_displacement"
body = "block"
point = [1, 2]
axis = "y"
)");
  EXPECT_EQ(a_case.measurements.at(0).of, 1);
  EXPECT_EQ(a_case.measurements.at(1).axis, 1);
  EXPECT_EQ(a_case.measurements.at(1).point, (Vector{1, 2, 0}));
}

TEST(read_case, a_case_may_have_three_dimensions) {
  const Case a_case = read_text(R"(
dimension = 3
[discretisation]
spacing = 0.05
[time]
end = 1
[[body]]
name = "ball"
geometry = { shape = "ball", centre = [0, 0, 1], radius = 0.5 }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
rotation = { centre = [0, 0, 1], angular_velocity = [0, 1, 0] }
[[boundary]]
name = "tube"
kind = "fixed"
geometry = { shape = "cylinder", centre = [2, 0, 0], radius = 0.1, axis = [0, 0, 4] }
)");
  EXPECT_EQ(a_case.dimension, 3);
  EXPECT_EQ(a_case.bodies.at(0).geometry.centre, (Vector{0, 0, 1}));
  const auto& rotation = *a_case.bodies.at(0).velocity.rotation;
  EXPECT_EQ(rotation.angular_velocity, (Vector{0, 1, 0}));
  EXPECT_EQ(a_case.boundaries.at(0).geometry.axis, (Vector{0, 0, 1}));
}

TEST(read_case, advice_has_as_many_components_as_the_case) {
  const std::string box = R"({ shape = "box", lower = [0, 0], upper = [1, 2] })";
  const std::string solid = "dimension = 3\n" + block_case;
  const std::string without = with(block_case, ", lower = [0, 0]", "");
  EXPECT_NE(complaint(without).find("add lower = [0, 0]"), std::string::npos);
  EXPECT_NE(complaint("dimension = 3\n" + without).find("add lower = [0, 0, 0]"),
            std::string::npos);
  EXPECT_NE(complaint(with(solid, box, "1")).find("lower = [0, 0, 0], upper = [1, 1, 1]"),
            std::string::npos);
  EXPECT_NE(complaint(with(solid, box, R"({ shape = "union" })")).find(R"(shape = "ball")"),
            std::string::npos);
}

TEST(read_case, examples_keep_their_meaning_in_other_dimensions) {
  EXPECT_EQ(with_components("[0, 1]", 3), "[0, 0, 1]");
  EXPECT_EQ(with_components("[1, 0.95]", 3), "[1, 1, 0.95]");
  EXPECT_EQ(with_components(R"([0, "-25*y"])", 3), R"([0, 0, "-25*y"])");
  EXPECT_EQ(with_components("[0, 0, 1]", 2), "[0, 1]");
  EXPECT_EQ(with_components(R"({ shape = "half_space", point = [0, 0], normal = [0, 1] })", 3),
            R"({ shape = "half_space", point = [0, 0, 0], normal = [0, 0, 1] })");
}

TEST(read_case, a_stress_at_the_start_has_components) {
  const Case a_case = read_text(block_case + R"toml(stress = { yy = "-4*(2 - y)", xy = 0.5 })toml");
  const auto stress = initial_stress(a_case.bodies.at(0), {0, 0.5, 0}, 2);
  EXPECT_EQ(stress[kernels::symmetric_index<3>(1, 1)], -6);
  EXPECT_EQ(stress[kernels::symmetric_index<3>(0, 1)], 0.5);
  EXPECT_NEAR(stress[kernels::symmetric_index<3>(2, 2)], -0.3 * 6, 1e-12) << "plane strain";
  EXPECT_NE(resolved_toml(a_case).find("stress = { xx = 0, yy = \"-4*(2 - y)\", xy = 0.5 }"),
            std::string::npos);
  EXPECT_NE(complaint(block_case + "stress = { zz = 1 }").find("unknown key `zz`"),
            std::string::npos);
}

TEST(read_case, rotation_in_two_dimensions_is_about_z) {
  const Case a_case =
      read_text(block_case + "rotation = { centre = [0.5, 1], angular_velocity = \"2*pi\" }\n");
  const auto& rotation = *a_case.bodies.at(0).velocity.rotation;
  EXPECT_DOUBLE_EQ(rotation.angular_velocity[2], 6.283185307179586);
  EXPECT_EQ(rotation.angular_velocity[0], 0);
}

TEST(read_case, a_periodic_cell_has_axes_and_corners) {
  const Case a_case =
      read_text(block_case + "[periodic]\naxes = [\"x\"]\nlower = [0, -inf]\nupper = [1, inf]\n");
  EXPECT_EQ(a_case.periodic.axis, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(a_case.periodic.upper[0], 1);
}

// A run that is continued to a later end then moves its walls as one long run does.
TEST(read_case, takes_the_velocity_of_a_displacement_over_a_time_that_does_not_depend_on_the_end) {
  const std::string text = block_case + R"(
[[boundary]]
name = "press"
kind = "moving_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
displacement = [0, "0.1*t^2"]
)";
  const double increment = read_text(text).boundaries.at(0).time_increment;
  EXPECT_GT(increment, 0);
  EXPECT_EQ(read_text(text, {"time.end=3"}).boundaries.at(0).time_increment, increment);
}

TEST(read_case, remeshings_are_rarer_where_walls_act_on_tied_bodies) {
  const std::string tied = block_case + R"(
[[body]]
name = "other"
geometry = { shape = "box", lower = [0, 2], upper = [1, 3] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
[[contact]]
bodies = ["block", "other"]
kind = "tied"
)";
  const std::string wall =
      "[[boundary]]\nname = \"floor\"\nkind = \"fixed\"\n"
      "geometry = { shape = \"half_space\", point = [0, 0], normal = [0, 1] }\n";
  EXPECT_EQ(read_text(tied).remeshing.strain_threshold, 0.18);
  EXPECT_EQ(read_text(tied).remeshing.deformation_threshold, 0.2);
  EXPECT_EQ(read_text(tied + wall).remeshing.strain_threshold, 0.4);
  EXPECT_EQ(read_text(tied + wall).remeshing.deformation_threshold, 1);
  const Case chosen = read_text(tied + wall, {"remeshing.deformation_threshold=0.3"});
  EXPECT_EQ(chosen.remeshing.deformation_threshold, 0.3);
}

}  // namespace
}  // namespace pliant
