#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Walls that turn, (RP.114), and moments of walls, (RP.115), in the remeshed method.
namespace pliant::test {
namespace {

constexpr double shear_modulus = 1000 / 2.6;

std::string text_of_case(int dimension, double spacing, const std::string& damping) {
  return fmt::format(
      "dimension = {}\ndiscretisation = {{ spacing = {}, damping = {} }}\ntime.end = 10\n"
      "[material.gel]\nmodel = \"neo_hookean\"\ndensity = 1\nyoungs_modulus = 1000\n"
      "poissons_ratio = 0.3\n",
      dimension, spacing, damping);
}

std::string body(const std::string& rest) {
  return "[[body]]\nname = \"block\"\nmaterial = \"gel\"\n" + rest + "\n";
}

std::string moment(const std::string& wall, const std::string& point) {
  return measurement(wall + "_moment", fmt::format("kind = \"wall_moment\"\nboundary = \"{}\"\n"
                                                   "point = {}",
                                                   wall, point));
}

std::string force(const std::string& wall, const std::string& axis) {
  return measurement(
      wall + "_" + axis,
      fmt::format("kind = \"wall_force\"\nboundary = \"{}\"\naxis = \"{}\"", wall, axis));
}

/// The means of all measurements of walls from `begin` to `end` [s].
std::map<std::string, double> means(pliant::Solver& solver, double begin, double end) {
  solver.advance(begin);
  const auto before = values(solver);
  solver.advance(end);
  auto mean = values(solver);
  for (auto& [name, value] : mean) value = (value - before.at(name)) / (end - begin);
  return mean;
}

/// A square of 1 m that turns with the wall at its left side, at 1 rad/s about the origin.
std::string square_on_turning_wall(double spacing) {
  return text_of_case(2, spacing, "0") +
         body(
             "geometry = { shape = \"box\", lower = [1, 0], upper = [2, 1] }\n"
             "rotation = { centre = [0, 0], angular_velocity = 1 }") +
         half_space("grip", "kind = \"moving_wall\"\nrotation = { centre = [0, 0], angle = \"t\" }",
                    "[1, 0]", "[1, 0]");
}

// The wall pulls the mass centre at r towards the axis with m w^2 r and gives it no spin. Strains
// are of the size of rho w^2 r^2/E = 0.004. It swings about this state, and is remeshed again and
// again.
TEST(turning_walls, carry_a_body_round) {
  const auto run =
      methods().make(tests::read_text(square_on_turning_wall(0.1) + force("grip", "x") +
                                      force("grip", "y") + moment("grip", "[0, 0]")),
                     {});
  const double begin = 0, end = 2;
  const auto mean = means(*run, begin, end);
  const double r = std::hypot(1.5, 0.5), at = std::atan2(0.5, 1.5);
  const double x = (std::sin(at + end) - std::sin(at + begin)) / (end - begin);
  const double y = (std::cos(at + begin) - std::cos(at + end)) / (end - begin);
  EXPECT_NEAR(mean.at("grip_x"), -r * x, 0.02 * r);
  EXPECT_NEAR(mean.at("grip_y"), -r * y, 0.02 * r);
  EXPECT_NEAR(mean.at("grip_moment"), 0, 0.02 * r);
  EXPECT_NEAR(balance(*run), balance(*methods().make(run->settings(), {})),
              0.01 * run->integrals().kinetic_energy);
}

// Torsion of a round bar: the torque is mu pi R^4/2 theta/l, and half of torque times theta is
// stored. The coarse surface costs a twentieth.
TEST(turning_walls, twist_a_round_bar) {
  const double radius = 0.1, length = 0.4;
  for (const double twist : {0.2, 0.8}) {
    const auto run = methods().make(
        tests::read_text(
            text_of_case(3, 0.025, "\"adaptive\"") +
            body("geometry = { shape = \"intersection\", of = [{ shape = \"cylinder\", centre = "
                 "[0, 0, 0], axis = [1, 0, 0], radius = 0.1 }, { shape = \"box\", lower = [0, -1, "
                 "-1], upper = [0.4, 1, 1] }] }") +
            half_space("base", "kind = \"fixed\"", "[0, 0, 0]", "[1, 0, 0]") +
            half_space("head",
                       fmt::format("kind = \"moving_wall\"\nrotation = {{ centre = [0.4, 0, 0], "
                                   "axis = [1, 0, 0], angle = \"{}*(1 - cos(pi*min(t/0.2, 1)))/2\" "
                                   "}}",
                                   twist),
                       "[0.4, 0, 0]", "[-1, 0, 0]") +
            moment("base", "[0, 0, 0]") + moment("head", "[0, 0.3, 0]")),
        {2});
    const auto mean = means(*run, 0.25, 0.3);
    const double torque =
        shear_modulus * std::numbers::pi * std::pow(radius, 4) / 2 * twist / length;
    EXPECT_NEAR(mean.at("head_moment"), torque, 0.06 * torque) << twist;
    EXPECT_NEAR(mean.at("base_moment"), -mean.at("head_moment"), 0.02 * torque) << twist;
    EXPECT_NEAR(balance(*run), 0, 0.02 * torque * twist / 2) << twist;
  }
}

// Two walls bend a block between them. The other methods find 159 N m/m on both walls.
TEST(turning_walls, bend_a_block) {
  const auto run = methods().make(
      tests::read_text(text_of_case(2, 0.05, "\"adaptive\"") +
                       body("geometry = { shape = \"box\", lower = [0, 0], upper = [1, 1] }") +
                       half_space("base", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
                       half_space("head",
                                  "kind = \"moving_wall\"\nrotation = { centre = [1, 0.5], angle = "
                                  "\"0.1*(1 - cos(pi*min(t/2, 1)))/2\" }",
                                  "[1, 0]", "[-1, 0]") +
                       moment("base", "[1, 0.5]") + moment("head", "[1, 0.5]")),
      {});
  const auto mean = means(*run, 3, 3.5);
  EXPECT_NEAR(mean.at("base_moment"), -15.9, 0.03 * 15.9);
  EXPECT_NEAR(mean.at("head_moment"), 15.9, 0.03 * 15.9);
  EXPECT_NEAR(balance(*run), 0, 0.01 * 0.795);
}

// Statics: the moment of what a single wall bears follows from the angular momentum of the body.
TEST(moments_of_walls, balance_the_weight_of_a_cantilever) {
  const auto run = methods().make(
      tests::read_text("gravity = [0, -1]\n" + text_of_case(2, 0.125, "\"adaptive\"") +
                       body("geometry = { shape = \"box\", lower = [0, 0], upper = [2, 1] }") +
                       half_space("clamp", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
                       force("clamp", "y") + moment("clamp", "[0, 0]") +
                       measurement("centre", "kind = \"centre_of_mass\"\naxis = \"x\"")),
      {});
  run->advance(8);
  const auto before = values(*run);
  run->advance(9);
  const auto after = values(*run);
  const double lever = (after.at("clamp_moment") - before.at("clamp_moment")) /
                       (after.at("clamp_y") - before.at("clamp_y"));
  EXPECT_NEAR(lever, after.at("centre"), 0.002 * after.at("centre"));
}

// A block that rests on a contact wall, 3 m from the point of the moment.
TEST(moments_of_walls, are_those_of_contact_walls_too) {
  const auto run = methods().make(
      tests::read_text("gravity = [0, -10]\n" + text_of_case(2, 0.1, "\"adaptive\"") +
                       body("geometry = { shape = \"box\", lower = [2.5, 0], upper = [3.5, 1] }") +
                       half_space("floor", "kind = \"contact_wall\"\nfriction = \"frictionless\"",
                                  "[0, 0]", "[0, 1]") +
                       force("floor", "y") + moment("floor", "[0, 0]")),
      {});
  const auto mean = means(*run, 3, 4);
  EXPECT_NEAR(mean.at("floor_moment") / mean.at("floor_y"), 3, 0.01);
}

}  // namespace
}  // namespace pliant::test
