#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Bodies that lie at an angle to the lattice rest on walls and on each other. Neighbouring corners
// of their surfaces push nearly the same particles, and what they push too far shakes a body that
// should be at rest.
namespace pliant::test {
namespace {

/// Directions along and across bodies that are turned by an angle.
struct Axes {
  double c, s;
  explicit Axes(double degrees)
      : c(std::cos(degrees * std::numbers::pi / 180)),
        s(std::sin(degrees * std::numbers::pi / 180)) {}
  std::string at(double x, double y) const {
    return fmt::format("[{}, {}]", x * c - y * s, x * s + y * c);
  }
  std::string half_space(double x, double y, double nx, double ny) const {
    return fmt::format("{{ shape = \"half_space\", point = {}, normal = {} }}", at(x, y),
                       at(nx, ny));
  }
};

std::string start_of_case(const std::string& method, double spacing = 0.1) {
  return fmt::format(
      "method = \"{0}\"\ndimension = 2\n{0}.damping = \"adaptive\"\ntime = {{ end = 6 }}\n"
      "discretisation = {{ spacing = {1} }}\n",
      method, spacing);
}

/// A block of 1 m from x = `from` on.
std::string block(const Axes& axes, const std::string& name, double from) {
  return fmt::format(R"([[body]]
name = "{}"
material = {{ model = "neo_hookean", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
geometry = {{ shape = "intersection", of = [{}, {}, {}, {}, {{ shape = "box", lower = [-3, -3], upper = [3, 3] }}] }}
)",
                     name, axes.half_space(from + 1, 0, 1, 0), axes.half_space(from, 0, -1, 0),
                     axes.half_space(0, 0.5, 0, 1), axes.half_space(0, -0.5, 0, -1));
}

/// Two walls, `apart` from each other, of which the first presses by 0.02 m.
std::string walls(const Axes& axes, const std::string& kind, double apart) {
  return fmt::format(
      "[[boundary]]\nname = \"first\"\nkind = \"{}\"\ndisplacement = [\"{}*min(t, 1)\", "
      "\"{}*min(t, 1)\"]\ngeometry = {}\n[[boundary]]\nname = \"second\"\nkind = \"{}\"\ngeometry "
      "= {}\n",
      kind, 0.02 * axes.c, 0.02 * axes.s, axes.half_space(0, 0, 1, 0), kind,
      axes.half_space(apart, 0, -1, 0));
}

/// Kinetic and strain energy and losses less the work, over the work, at the end.
double created(const std::string& text) {
  const Case settings = tests::read_text(text);
  const auto run = methods().make(settings, {});
  run->advance(settings.time.end);
  return balance(*run) / run->energy_budget()->work();
}

// It was 0.06 and 0.03 after 6 s, and growing.
TEST(inclined_contact, a_block_rests_between_contact_walls) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const double degrees : {20, 45}) {
      const Axes axes(degrees);
      const std::string text =
          start_of_case(method) + block(axes, "block", 0) + walls(axes, "contact_wall", 1);
      EXPECT_NEAR(created(text), 0, 0.02) << method << ' ' << degrees;
    }
  }
}

// With four sweeps it was 0.4 after 4 s, and with friction 0.7; with 16 sweeps it was 0.1 with a
// spacing of 0.08 m.
TEST(inclined_contact, blocks_rest_on_each_other) {
  for (const auto& [method, spacing] :
       {std::pair{"total_lagrangian", 0.1}, std::pair{"point_based", 0.1},
        std::pair{"point_based", 0.08}}) {
    for (const std::string law :
         {"kind = \"frictionless\"", "kind = \"coulomb\"\nfriction = 0.3"}) {
      const Axes axes(45);
      const std::string text = start_of_case(method, spacing) + block(axes, "one", 0) +
                               block(axes, "two", 1) + walls(axes, "slip_wall", 2) +
                               "[[contact]]\nbodies = [\"one\", \"two\"]\n" + law + "\n";
      EXPECT_NEAR(created(text), 0, 0.02) << method << spacing << law;
    }
  }
}

}  // namespace
}  // namespace pliant::test
