#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Walls that cut cells of the lattice, compared with solutions in closed form.
namespace pliant::test {
namespace {

constexpr double young = 1000, nu = 0.3;

std::string start_of_case(int dimension, double spacing) {
  return fmt::format(R"(method = "total_lagrangian"
dimension = {}
discretisation = {{ spacing = {} }}
total_lagrangian = {{ damping = "adaptive" }}
time = {{ end = 2 }}
[material.m]
model = "neo_hookean"
density = 1
youngs_modulus = {}
poissons_ratio = {}
[[body]]
name = "body"
material = "m"
)",
                     dimension, spacing, young, nu);
}

std::string written(const std::vector<double>& x) {
  return fmt::format("[{}]", fmt::join(x, ", "));
}

/// A half-space of material up to the plane at `distance` from the origin along `normal`.
std::string up_to(const std::vector<double>& normal, double distance) {
  std::vector<double> point = normal;
  for (double& component : point) component *= distance;
  return fmt::format("{{ shape = \"half_space\", point = {}, normal = {} }}", written(point),
                     written(normal));
}

std::vector<double> opposite(std::vector<double> x) {
  for (double& component : x) component = -component;
  return x;
}

std::unique_ptr<pliant::Solver> at_rest(const std::string& text) {
  const Case settings = tests::read_text(text);
  auto solver = methods().make(settings, {});
  solver->advance(2);
  return solver;
}

/// A prism of 1 m between two walls at right angles to axes[0], and free along the other axes. The
/// first wall moves by 0.002 m. The strain energy over that of the uniaxial stress in it.
double pressed_prism(const std::vector<std::vector<double>>& axes, double spacing,
                     const std::string& kind) {
  const int dimension = static_cast<int>(axes.size());
  std::string faces = up_to(axes[0], 1) + ", " + up_to(opposite(axes[0]), 0);
  for (int a = 1; a < dimension; ++a) {
    faces += ", " + up_to(axes[a], 0.5) + ", " + up_to(opposite(axes[a]), 0.5);
  }
  const std::string far = dimension == 2 ? "3, 3]" : "3, 3, 3]";
  std::vector<std::string> moved;
  for (const double n : axes[0]) moved.push_back(fmt::format("\"{}*min(t, 1)\"", 0.002 * n));
  const std::string text =
      start_of_case(dimension, spacing) +
      fmt::format(
          "geometry = {{ shape = \"intersection\", of = [{}, {{ shape = \"box\", lower = "
          "[{}, upper = [{} }}] }}\n",
          faces, dimension == 2 ? "-3, -3]" : "-3, -3, -3]", far) +
      fmt::format("[[boundary]]\nname = \"pressing\"\nkind = \"{}\"\ndisplacement = [{}]\n",
                  kind == "fixed" ? "moving_wall" : kind, fmt::join(moved, ", ")) +
      "geometry = " + up_to(axes[0], 0) + "\n" +
      fmt::format("[[boundary]]\nname = \"end\"\nkind = \"{}\"\ngeometry = ", kind) +
      fmt::format("{{ shape = \"half_space\", point = {}, normal = {} }}\n", written(axes[0]),
                  written(opposite(axes[0])));
  const double uniaxial = dimension == 2 ? young / (1 - nu * nu) : young;
  return at_rest(text)->integrals().strain_energy / (0.002 * 0.002 / 2 * uniaxial);
}

std::vector<std::vector<double>> turned(double degrees) {
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  return {{c, s}, {-s, c}};
}

// It was 0.96, 0.95 and 0.91 of that.
TEST(inclined_walls, press_a_block_with_the_energy_of_its_stress) {
  for (const double degrees : {20, 30, 45}) {
    EXPECT_NEAR(pressed_prism(turned(degrees), 0.1, "slip_wall"), 1, 0.015) << degrees;
  }
  const double third = 1 / std::sqrt(3.), half = 1 / std::sqrt(2.), sixth = 1 / std::sqrt(6.);
  EXPECT_NEAR(pressed_prism({{third, third, third}, {half, -half, 0}, {sixth, sixth, -2 * sixth}},
                            0.125, "slip_wall"),
              1, 0.03);
}

TEST(inclined_walls, that_hold_a_block_press_it_as_walls_along_the_lattice_do) {
  const double along = pressed_prism(turned(0), 0.1, "fixed");
  for (const double degrees : {20, 30, 45}) {
    EXPECT_NEAR(pressed_prism(turned(degrees), 0.1, "fixed") / along, 1, 0.015) << degrees;
  }
}

// A beam at 30 degrees with three particles across bends by 0.86 of what one along the lattice
// does.
TEST(inclined_bodies, of_few_particles_are_warned_of) {
  const auto warnings = [](double degrees, double spacing) {
    const auto axes = turned(degrees);
    return warnings_of_method(tests::read_text(
        start_of_case(2, spacing) +
        fmt::format("geometry = {{ shape = \"intersection\", of = [{}, {}, {{ shape = \"box\", "
                    "lower = [-2, -2], upper = [2, 2] }}] }}\n",
                    up_to(axes[1], 0.5), up_to(opposite(axes[1]), 0.5))));
  };
  ASSERT_EQ(warnings(30, 0.33).size(), 1u);
  EXPECT_NE(warnings(30, 0.33)[0].find("it bends 7 to 15 % too little"), std::string::npos);
  EXPECT_TRUE(warnings(30, 0.16).empty());
  EXPECT_TRUE(warnings(0, 0.33).empty());
}

std::string ball(int dimension, double radius) {
  return fmt::format("{{ shape = \"{}\", centre = {}, radius = {} }}",
                     dimension == 2 ? "disc" : "ball", dimension == 2 ? "[0, 0]" : "[0, 0, 0]",
                     radius);
}

std::string displacement_at(const std::string& name, int dimension, double r, double angle) {
  std::vector<double> point = {r * std::cos(angle), r * std::sin(angle)};
  if (dimension == 3) point.push_back(0);
  return measurement(
      name, "kind = \"point_displacement\"\naxis = \"x\"\npoint = " + written(point) + "\n");
}

// It was 1.094 and 1.066 of Lame's displacement with 6 and 8 across.
TEST(inclined_walls, bound_a_sector_of_a_ring_that_widens_as_the_ring) {
  for (const int across : {4, 6, 8}) {
    const std::string text =
        start_of_case(2, 0.5 / across) + "geometry = { shape = \"difference\", of = [" +
        ball(2, 1) + ", " + ball(2, 0.5) + "] }\n" +
        half_space("upper", "kind = \"slip_wall\"", "[0, 0]", "[1, -1]") +
        half_space("lower", "kind = \"slip_wall\"", "[0, 0]", "[1, 1]") +
        "[[boundary]]\nname = \"inside\"\nkind = \"pressure\"\npressure = 1\ngeometry = " +
        ball(2, 0.75) + "\n" + displacement_at("middle", 2, 0.75, 0) +
        displacement_at("beside", 2, 0.75, 0.7) + displacement_at("out", 2, 0.95, 0.3);
    auto found = values(*at_rest(text));
    const auto lame = [](double r) {
      return (1 + nu) / young * (0.25 / 0.75) * ((1 - 2 * nu) * r + 1 / r);
    };
    const double bar = across == 4 ? 0.025 : 0.015;
    EXPECT_NEAR(found["middle"] / lame(0.75), 1, bar) << across;
    EXPECT_NEAR(found["beside"] / (lame(0.75) * std::cos(0.7)), 1, bar) << across;
    EXPECT_NEAR(found["out"] / (lame(0.95) * std::cos(0.3)), 1, bar) << across;
  }
}

std::string named(const std::string& place, double angle) {
  return fmt::format("{}_{:.0f}", place, angle * 180 / std::numbers::pi);
}

// A spacing outside the core, displacements were wrong by up to 60 %.
TEST(inclined_walls, a_core_in_a_ring_or_ball_holds_it_where_it_is) {
  for (const auto& [dimension, across] : {std::pair{2, 8}, std::pair{2, 12}, std::pair{3, 5}}) {
    for (const std::string kind : {"fixed", "slip_wall"}) {
      if (dimension == 3 && kind == "slip_wall") continue;
      const double h = 0.5 / across;
      std::string text =
          start_of_case(dimension, h) + "geometry = { shape = \"difference\", of = [" +
          ball(dimension, 1) + ", " + ball(dimension, 0.5) +
          "] }\n[[boundary]]\nname = \"core\"\nkind = \"" + kind +
          "\"\ngeometry = " + ball(dimension, 0.5) +
          "\n[[boundary]]\nname = \"outside\"\nkind = \"pressure\"\npressure = 1\ngeometry = { "
          "shape = \"difference\", of = [{ shape = \"box\", lower = " +
          (dimension == 2 ? "[-9, -9], upper = [9, 9]" : "[-9, -9, -9], upper = [9, 9, 9]") +
          " }, " + ball(dimension, 0.75) + "] }\n";
      const std::vector<double> angles = {0, std::atan2(0.6, 0.8), std::numbers::pi / 4};
      for (const double angle : angles) {
        text += displacement_at(named("near", angle), dimension, 0.5 + h, angle) +
                displacement_at(named("middle", angle), dimension, 0.75, angle);
      }
      const double lambda = young * nu / (1 + nu) / (1 - 2 * nu), mu = young / 2 / (1 + nu);
      const double scale = dimension == 2 ? -1 / (2 * (lambda + mu) + 2 * mu * 0.25)
                                          : -1 / (3 * lambda + 2 * mu + 4 * mu * 0.125);
      const auto exact = [&, d = dimension](double r) {
        return scale * (r - std::pow(0.5, d) / std::pow(r, d - 1));
      };
      auto found = values(*at_rest(text));
      for (const double angle : angles) {
        const double cosine = std::cos(angle);
        EXPECT_NEAR(found[named("near", angle)] / (exact(0.5 + h) * cosine), 1, 0.05)
            << dimension << ' ' << across << kind << angle;
        EXPECT_NEAR(found[named("middle", angle)] / (exact(0.75) * cosine), 1,
                    dimension == 2 ? 0.006 : 0.02)
            << dimension << ' ' << across << kind << angle;
      }
    }
  }
}

}  // namespace
}  // namespace pliant::test
