#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Adaptive damping, (TL.10), (PB.65).
namespace pliant::test {
namespace {

constexpr const char* both_methods[] = {"total_lagrangian", "point_based"};

std::string start(const std::string& method, double end, const std::string& rest = "") {
  return fmt::format("method = \"{}\"\ntime.end = {}\n{}", method, end, rest);
}

std::string body(const std::string& geometry, double youngs_modulus) {
  return fmt::format(
      "[[body]]\nname = \"b\"\ngeometry = {}\nmaterial = {{ model = \"neo_hookean\", "
      "youngs_modulus = {}, poissons_ratio = 0.3, density = 1 }}\n",
      geometry, youngs_modulus);
}

std::string force(const std::string& wall) {
  return measurement(wall, "kind = \"wall_force\"\naxis = \"y\"\nboundary = \"" + wall + "\"");
}

// A cantilever that bends under its slowly growing weight [m/s^2].
double deflection(const std::string& method, const std::string& precision, double weight) {
  const std::string text =
      start(method, 8,
            "precision = \"" + precision +
                fmt::format("\"\ngravity = [0, \"-{}*min(t/2, 1)\"]\n", weight) +
                "discretisation = { spacing = \"1/24\", damping = \"adaptive\" }\n") +
      body("{ shape = \"box\", lower = [0, 0], upper = [4, 1] }", 1000) +
      half_space("clamp", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
      measurement("tip", "kind = \"point_displacement\"\naxis = \"y\"\npoint = [3.98, 0.52]");
  const auto run = methods().make(tests::read_text(text), {});
  run->advance(8);
  return values(*run)["tip"];
}

// From one step to the next, rounding to single precision changes the forces more than the slow
// motion does.
TEST(adaptive_damping, brings_a_body_to_rest_in_single_precision_too) {
  for (const std::string method : both_methods) {
    const double exact = deflection(method, "double", 1.5);
    EXPECT_NEAR(exact, -0.546, 0.0005) << method;
    EXPECT_NEAR(deflection(method, "single", 1.5), exact, 2e-4) << method;
  }
}

// Rounding looked like stiffness, so that mean strains of 6e-5 came with 0.9 of the deflection, and
// those of 6e-6 with 0.04.
TEST(adaptive_damping, brings_a_body_that_hardly_strains_to_rest_in_single_precision) {
  for (const std::string method : both_methods) {
    const double exact = deflection(method, "double", 6e-3);
    EXPECT_NEAR(deflection(method, "single", 6e-3), exact, -0.03 * exact) << method;
  }
}

// With the change of internal forces in place of accelerations, the moving wall met 8 % more force
// than the fixed one.
TEST(adaptive_damping, lets_a_load_grow) {
  for (const std::string method : both_methods) {
    const std::string text =
        start(method, 4, "discretisation = { spacing = \"1/12\", damping = \"adaptive\" }\n") +
        body("{ shape = \"box\", lower = [0, 0], upper = [1, 2] }", 100) +
        half_space("fixed", "kind = \"fixed\"", "[0, 0]", "[0, 1]") +
        half_space("moving", "kind = \"moving_wall\"\ndisplacement = [0, \"0.05*t\"]", "[0, 2]",
                   "[0, -1]") +
        force("fixed") + force("moving");
    const auto run = methods().make(tests::read_text(text), {});
    run->advance(3.8);
    const auto before = values(*run);
    run->advance(4);
    const auto after = values(*run);
    const double fixed = (before.at("fixed") - after.at("fixed")) / 0.2,
                 moving = (after.at("moving") - before.at("moving")) / 0.2;
    EXPECT_NEAR(fixed / moving, 1, 0.04) << method;
    EXPECT_NEAR((fixed + moving) / 2, 0.975 * 10.54, 0.02 * 10.54) << method;
  }
}

// With the velocities before each step alone, the disc seemed to create 0.1 of its energy.
TEST(adaptive_damping, loses_what_a_disc_has_gained_that_drops_onto_a_wall) {
  for (const std::string method : both_methods) {
    const std::string text = start(method, 3,
                                   "gravity = [0, -8]\ndiscretisation = { spacing = \"1/12\", "
                                   "damping = \"adaptive\" }\n") +
                             body("{ shape = \"disc\", centre = [0, 1.3], radius = 1 }", 100) +
                             half_space("floor", "kind = \"contact_wall\"", "[0, 0]", "[0, 1]");
    const auto run = methods().make(tests::read_text(text), {});
    run->advance(3);
    EXPECT_NEAR(balance(*run) / run->energy_budget()->work(), 0, 0.025) << method;
  }
}

// Velocities half a step before positions did not know of contact, and had 0.02 of the strain
// energy.
TEST(adaptive_damping, leaves_no_kinetic_energy_under_a_tool_and_between_bodies) {
  const std::string block =
      start("total_lagrangian", 4,
            "gravity = [0, -5]\ndiscretisation = { spacing = 0.125, damping = \"adaptive\" }\n") +
      body("{ shape = \"box\", lower = [-2, 0], upper = [2, 1.5] }", 100) +
      half_space("clamp", "kind = \"fixed\"", "[0, 0]", "[0, 1]");
  const std::string disc = "{ shape = \"disc\", centre = [0, 2], radius = 0.5 }";
  const std::string tool =
      "[[boundary]]\nname = \"tool\"\nkind = \"contact_wall\"\n"
      "displacement = [0, \"-0.25*min(t/2, 1)\"]\ngeometry = " +
      disc + "\n";
  const std::string ball =
      "[[body]]\nname = \"ball\"\ngeometry = " + disc +
      "\nmaterial = { model = \"neo_hookean\", youngs_modulus = 100, poissons_ratio = 0.3, "
      "density = 1 }\n[[contact]]\nbodies = [\"b\", \"ball\"]\n";
  for (const std::string& pressed : {tool, ball}) {
    const auto run = methods().make(tests::read_text(block + pressed), {});
    run->advance(4);
    const BodyIntegrals sum = run->integrals();
    EXPECT_LT(sum.kinetic_energy, 1e-5 * sum.strain_energy) << pressed;
  }
}

}  // namespace
}  // namespace pliant::test
