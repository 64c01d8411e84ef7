#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Turning walls, (TL.31), compared with rigid motion and torsion, and their work.
namespace pliant::test {
namespace {

constexpr double elastic_modulus = 1000, contraction = 0.3,
                 shear_modulus = elastic_modulus / (2 * (1 + contraction));

std::string text_of_case(const std::string& method, double spacing, const std::string& damping) {
  return fmt::format(
      "method = \"{0}\"\ndimension = 3\ndiscretisation = {{ spacing = {1} }}\n"
      "time = {{ end = 10 }}\n[{0}]\ndamping = {2}\n[material.gel]\nmodel = \"neo_hookean\"\n"
      "density = 1\nyoungs_modulus = {3}\npoissons_ratio = {4}\n",
      method, spacing, damping, elastic_modulus, contraction);
}

// Every particle is in the wall, so that there is no strain: L is that of a rigid body.
TEST(turning_walls, carry_what_they_hold_as_a_rigid_body) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const std::string text =
        text_of_case(method, 0.1, "0") +
        R"([[body]]
name = "block"
material = "gel"
geometry = { shape = "box", lower = [0, 0, 0], upper = [0.4, 0.3, 0.2] }
[[boundary]]
name = "grip"
kind = "moving_wall"
velocity = [0, 0.5, 0]
rotation = { centre = [0.2, 0.1, 0], axis = [0, 0, 1], angle = "2*t^2" }
geometry = { shape = "box", lower = [-1, -1, -1], upper = [2, 2, 2] }
)" + measurement("x", "kind = \"point_displacement\"\naxis = \"x\"\npoint = [0.4, 0.3, 0.1]\n") +
        measurement("y", "kind = \"point_displacement\"\naxis = \"y\"\npoint = [0.4, 0.3, 0.1]\n") +
        measurement("strain_energy", "kind = \"strain_energy\"\n");
    // If all nodes are held, the default step would be the whole run.
    const std::string step = "end = 10, step = 0.002";
    const auto run = methods().make(tests::read_text(tests::with(text, "end = 10", step)), {});
    const double end = 1;
    run->advance(end);
    const double angle = 2 * end * end, c = std::cos(angle), s = std::sin(angle);
    auto found = values(*run);
    // Velocities are those of the middle of a step: the error is (omega dt)^2/24 of the path.
    EXPECT_NEAR(found["x"], 0.2 * c - 0.2 * s - 0.2, 2e-4) << method;
    EXPECT_NEAR(found["y"], 0.2 * s + 0.2 * c - 0.2 + 0.5 * end, 2e-4) << method;
    EXPECT_NEAR(found["strain_energy"], 0, 1e-4 * elastic_modulus * 0.024) << method;
  }
}

// A square bar of side a twisted by theta over its length l: the torque is 0.1406 mu a^4 theta/l
// (Saint-Venant), and the work of the wall, torque times theta over 2, is stored.
TEST(turning_walls, twist_a_bar_with_the_moment_of_saint_venant) {
  constexpr double side = 0.2, length = 1, twist = 0.1;
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const std::string text =
        text_of_case(method, 0.025, "2") +
        fmt::format(R"toml([[body]]
name = "bar"
material = "gel"
geometry = {{ shape = "box", lower = [0, -0.1, -0.1], upper = [1, 0.1, 0.1] }}
[[boundary]]
name = "base"
kind = "fixed"
geometry = {{ shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }}
[[boundary]]
name = "head"
kind = "moving_wall"
rotation = {{ centre = [1, 0, 0], axis = [1, 0, 0], angle = "{}*min(t/2, 1)" }}
geometry = {{ shape = "half_space", point = [1, 0, 0], normal = [-1, 0, 0] }}
)toml",
                    twist) +
        measurement("torque",
                    "kind = \"wall_moment\"\nboundary = \"head\"\naxis = \"x\"\npoint = [0.5, 0.3, "
                    "0.1]\n") +
        measurement(
            "at_base",
            "kind = \"wall_moment\"\nboundary = \"base\"\naxis = \"x\"\npoint = [0, 0, 0]\n") +
        measurement("strain_energy", "kind = \"strain_energy\"\n");
    const auto run = methods().make(tests::read_text(text), {});
    run->advance(4);
    const auto before = values(*run);
    run->advance(5);
    auto after = values(*run);
    const double torque = after["torque"] - before.at("torque");
    // Both ends prevent warping of the section, which stiffens the bar by about a / (4 l).
    const double free_warping = 0.1406 * shear_modulus * std::pow(side, 4) * twist / length;
    EXPECT_GT(torque, free_warping) << method;
    EXPECT_LT(torque, (1 + 0.25 * side / length) * free_warping) << method;
    EXPECT_NEAR(after["at_base"] - before.at("at_base"), -torque, 0.005 * torque) << method;
    EXPECT_NEAR(after["strain_energy"], torque * twist / 2, 0.01 * torque * twist) << method;
  }
}

// A rough drum turns under a block that a weight presses on it, and drags the block along.
TEST(turning_walls, drag_what_lies_on_them_by_friction) {
  const std::string text = R"(method = "total_lagrangian"
dimension = 2
discretisation = { spacing = 0.05 }
gravity = [0, -10]
time = { end = 1 }
[[body]]
name = "block"
material = { model = "neo_hookean", density = 1, youngs_modulus = 2000, poissons_ratio = 0.3 }
geometry = { shape = "box", lower = [-0.1, 0], upper = [0.1, 0.2] }
[[boundary]]
name = "drum"
kind = "contact_wall"
friction = 0.2
rotation = { centre = [0, -50], angle = "-0.2*t" }
geometry = { shape = "disc", centre = [0, -50], radius = 50 }
)" + measurement("momentum", "kind = \"momentum\"\naxis = \"x\"\n");
  const auto run = methods().make(tests::read_text(text), {});
  // The surface moves at 10 m/s: Coulomb's law gives 0.2 g as long as the block is slower.
  run->advance(1);
  EXPECT_NEAR(values(*run)["momentum"], 0.2 * 10 * 0.04, 0.03 * 0.2 * 10 * 0.04);
}

}  // namespace
}  // namespace pliant::test
