#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Walls and bodies at an angle to the lattice, compared with solutions in closed form.
namespace pliant::test::inclined {
namespace {

constexpr double young = 1000, nu = 0.3;

std::string start_of_case(const std::string& method, int dimension, double spacing) {
  return fmt::format(R"(method = "{0}"
dimension = {1}
discretisation = {{ spacing = {2} }}
{0} = {{ damping = "adaptive" }}
time = {{ end = 2 }}
[material.m]
model = "neo_hookean"
density = 1
youngs_modulus = {3}
poissons_ratio = {4}
[[body]]
name = "body"
material = "m"
)",
                     method, dimension, spacing, young, nu);
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
double pressed_prism(const std::string& method, const std::vector<std::vector<double>>& axes,
                     double spacing, const std::string& kind) {
  const int dimension = static_cast<int>(axes.size());
  std::string faces = up_to(axes[0], 1) + ", " + up_to(opposite(axes[0]), 0);
  for (int a = 1; a < dimension; ++a) {
    faces += ", " + up_to(axes[a], 0.5) + ", " + up_to(opposite(axes[a]), 0.5);
  }
  const std::string far = dimension == 2 ? "3, 3]" : "3, 3, 3]";
  std::vector<std::string> moved;
  for (const double n : axes[0]) moved.push_back(fmt::format("\"{}*min(t, 1)\"", 0.002 * n));
  const std::string text =
      start_of_case(method, dimension, spacing) +
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

// It was 0.96, 0.95 and 0.91 of that in the total Lagrangian method, and 0.96 in the point-based
// one.
TEST(inclined_walls, press_a_block_with_the_energy_of_its_stress) {
  const double third = 1 / std::sqrt(3.), half = 1 / std::sqrt(2.), sixth = 1 / std::sqrt(6.);
  for (const auto& [method, bar] :
       {std::pair{"total_lagrangian", 0.015}, std::pair{"point_based", 0.025}}) {
    for (const double degrees : {20, 30, 45}) {
      EXPECT_NEAR(pressed_prism(method, turned(degrees), 0.1, "slip_wall"), 1, bar)
          << method << degrees;
    }
    EXPECT_NEAR(
        pressed_prism(method, {{third, third, third}, {half, -half, 0}, {sixth, sixth, -2 * sixth}},
                      0.125, "slip_wall"),
        1, 0.03)
        << method;
  }
}

TEST(inclined_walls, that_hold_a_block_press_it_as_walls_along_the_lattice_do) {
  for (const auto& [method, bar] :
       {std::pair{"total_lagrangian", 0.015}, std::pair{"point_based", 0.03}}) {
    const double along = pressed_prism(method, turned(0), 0.1, "fixed");
    for (const double degrees : {20, 30, 45}) {
      EXPECT_NEAR(pressed_prism(method, turned(degrees), 0.1, "fixed") / along, 1, bar)
          << method << degrees;
    }
  }
}

// A beam at 30 degrees with three particles across bends by 0.86 of what one along the lattice
// does, the arm of a bracket with eight by 0.96.
TEST(inclined_bodies, of_few_particles_are_warned_of) {
  const auto warnings = [](double degrees, double spacing) {
    const auto axes = turned(degrees);
    return warnings_of_method(tests::read_text(
        start_of_case("total_lagrangian", 2, spacing) +
        fmt::format("geometry = {{ shape = \"intersection\", of = [{}, {}, {{ shape = \"box\", "
                    "lower = [-2, -2], upper = [2, 2] }}] }}\n",
                    up_to(axes[1], 0.5), up_to(opposite(axes[1]), 0.5))));
  };
  ASSERT_EQ(warnings(30, 0.33).size(), 1u);
  EXPECT_NE(warnings(30, 0.33)[0].find("it bends 7 to 15 % too little"), std::string::npos);
  ASSERT_EQ(warnings(30, 0.16).size(), 1u);
  EXPECT_NE(warnings(30, 0.16)[0].find("it bends up to 8 % too little"), std::string::npos);
  EXPECT_TRUE(warnings(30, 0.09).empty());
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

// It was 1.094 and 1.066 of Lame's displacement with 6 and 8 across in the total Lagrangian method.
TEST(inclined_walls, bound_a_sector_of_a_ring_that_widens_as_the_ring) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const int across : {4, 6, 8}) {
      if (across == 4 && method == "point_based") continue;  // up to 14 % off
      const std::string text =
          start_of_case(method, 2, 0.5 / across) + "geometry = { shape = \"difference\", of = [" +
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
      EXPECT_NEAR(found["middle"] / lame(0.75), 1, bar) << method << across;
      EXPECT_NEAR(found["beside"] / (lame(0.75) * std::cos(0.7)), 1, bar) << method << across;
      EXPECT_NEAR(found["out"] / (lame(0.95) * std::cos(0.3)), 1, bar) << method << across;
    }
  }
}

std::string named(const std::string& place, double angle) {
  return fmt::format("{}_{:.0f}", place, angle * 180 / std::numbers::pi);
}

/// A ring or a hollow ball around a rigid core, under a pressure from outside: the errors of its
/// displacements a spacing from the core, in the middle and on the surface, relative to Lame's, and
/// of the von Mises stress there.
struct CoreErrors {
  double near = 0, middle = 0, outer = 0, stress = 0;
};

std::string stress_at(const std::string& name, int dimension, double r, double angle) {
  std::vector<double> point = {r * std::cos(angle), r * std::sin(angle)};
  if (dimension == 3) point.push_back(0);
  return measurement(name, "kind = \"material_value\"\nfield = \"von_mises_stress\"\npoint = " +
                               written(point) + "\n");
}

/// Von Mises stress at r = 1 for the displacement r - 0.5^D/r^(D - 1) along the radius [Pa].
double mises_of_core(int dimension) {
  const double mu = young / 2 / (1 + nu), lambda = young * nu / (1 + nu) / (1 - 2 * nu);
  const double b = std::pow(0.5, dimension), radial = 1 + (dimension - 1) * b, along = 1 - b;
  const double axial = dimension == 2 ? 0 : along, trace = radial + along + axial;
  const std::array<double, 3> stress = {lambda * trace + 2 * mu * radial,
                                        lambda * trace + 2 * mu * along,
                                        lambda * trace + 2 * mu * axial};
  return std::sqrt((std::pow(stress[0] - stress[1], 2) + std::pow(stress[1] - stress[2], 2) +
                    std::pow(stress[2] - stress[0], 2)) /
                   2);
}

CoreErrors errors_around_a_core(const std::string& method, int dimension, int across,
                                const std::string& kind) {
  const double h = 0.5 / across;
  std::string text =
      start_of_case(method, dimension, h) + "geometry = { shape = \"difference\", of = [" +
      ball(dimension, 1) + ", " + ball(dimension, 0.5) +
      "] }\n[[boundary]]\nname = \"core\"\nkind = \"" + kind +
      "\"\ngeometry = " + ball(dimension, 0.5) +
      "\n[[boundary]]\nname = \"outside\"\nkind = \"pressure\"\npressure = "
      "1\ngeometry = { shape = \"difference\", of = [{ shape = \"box\", lower = " +
      (dimension == 2 ? "[-9, -9], upper = [9, 9]" : "[-9, -9, -9], upper = [9, 9, 9]") + " }, " +
      ball(dimension, 0.75) + "] }\n";
  std::vector<double> angles;
  for (int k = 0; k <= 7; ++k) angles.push_back(k * std::numbers::pi / 28);
  for (const double angle : angles) {
    text += displacement_at(named("near", angle), dimension, 0.5 + h, angle) +
            displacement_at(named("middle", angle), dimension, 0.75, angle) +
            displacement_at(named("outer", angle), dimension, 1, angle) +
            stress_at(named("stress", angle), dimension, 1, angle);
  }
  const double lambda = young * nu / (1 + nu) / (1 - 2 * nu), mu = young / 2 / (1 + nu);
  const double scale = dimension == 2 ? -1 / (2 * (lambda + mu) + 2 * mu * 0.25)
                                      : -1 / (3 * lambda + 2 * mu + 4 * mu * 0.125);
  auto found = values(*at_rest(text));
  CoreErrors errors;
  for (const double angle : angles) {
    const auto error = [&](const std::string& place, double r) {
      const double exact = scale * (r - std::pow(0.5, dimension) / std::pow(r, dimension - 1));
      return std::abs(found[named(place, angle)] / (exact * std::cos(angle)) - 1);
    };
    errors.near = std::max(errors.near, error("near", 0.5 + h));
    errors.middle = std::max(errors.middle, error("middle", 0.75));
    errors.outer = std::max(errors.outer, error("outer", 1));
    const double stress = std::abs(scale) * mises_of_core(dimension);
    errors.stress = std::max(errors.stress, std::abs(found[named("stress", angle)] / stress - 1));
  }
  return errors;
}

// A spacing outside the core, displacements were wrong by up to 60 %. On the outer surface, in the
// total Lagrangian method, they were up to 4 %, and stresses 0.14 (3D: 1.35) off. With 12 across,
// in the total Lagrangian method, a point there was found in a twisted cell inside the core, and
// did not move.
TEST(inclined_walls, a_core_in_a_ring_or_ball_holds_it_where_it_is) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const auto& [dimension, across] : {std::pair{2, 8}, std::pair{2, 12}, std::pair{3, 5}}) {
      for (const std::string kind : {"fixed", "slip_wall"}) {
        if (dimension == 3 && kind == "slip_wall") continue;
        SCOPED_TRACE(fmt::format("{} {}D {} {}", method, dimension, across, kind));
        const CoreErrors errors = errors_around_a_core(method, dimension, across, kind);
        EXPECT_LT(errors.near, method == "point_based" ? 0.12 : 0.05);
        const bool guides_points = method == "point_based" && kind == "slip_wall" && across == 8;
        EXPECT_LT(errors.middle, dimension == 3 ? 0.02 : guides_points ? 0.025 : 0.006);
        EXPECT_LT(errors.outer, guides_points ? 0.02 : 0.007);
        EXPECT_LT(errors.stress, dimension == 3 ? 0.13 : 0.015);
      }
    }
  }
}

// A ring is twisted by a traction along its rim: it turned 3 to 16 % too far in the point-based
// method.
TEST(inclined_walls, a_core_holds_a_ring_that_is_twisted) {
  const double mu = young / 2 / (1 + nu);
  for (const auto& [method, bar] :
       {std::pair{"total_lagrangian", 0.005}, std::pair{"point_based", 0.02}}) {
    for (const int across : {5, 7, 8, 12}) {
      const std::string text =
          start_of_case(method, 2, 0.5 / across) + "geometry = " + ball(2, 1) +
          "\n[[boundary]]\nname = \"core\"\nkind = \"fixed\"\ngeometry = " + ball(2, 0.5) +
          "\n[[boundary]]\nname = \"rim\"\nkind = \"traction\"\ntraction = [\"-y\", "
          "\"x\"]\ngeometry = { shape = \"box\", lower = [-9, -9], upper = [9, 9] }\n" +
          measurement("turned", "kind = \"point_displacement\"\npoint = [0, 0.9]");
      auto found = values(*at_rest(text));
      EXPECT_NEAR(-found["turned"] / ((0.9 / 0.25 - 1 / 0.9) / (2 * mu)), 1, bar)
          << method << across;
    }
  }
}

// At 45 degrees the point-based method had 1.19 of the energy.
TEST(inclined_bodies, are_compressed_by_a_pressure_as_they_should) {
  const double lambda = young * nu / (1 + nu) / (1 - 2 * nu), mu = young / 2 / (1 + nu);
  for (const auto& [method, bar] :
       {std::pair{"total_lagrangian", 0.03}, std::pair{"point_based", 0.08}}) {
    for (const double degrees : {20, 30, 45}) {
      const auto axes = turned(degrees);
      std::string faces;
      for (const auto& axis : axes) {
        faces += up_to(axis, 0.5) + ", " + up_to(opposite(axis), 0.5) + ", ";
      }
      const std::string text =
          start_of_case(method, 2, 0.125) + "geometry = { shape = \"intersection\", of = [" +
          faces +
          "{ shape = \"box\", lower = [-2, -2], upper = [2, 2] }] }\n[[boundary]]\nname = "
          "\"all\"\nkind = \"pressure\"\npressure = 1\ngeometry = { shape = \"box\", lower = [-9, "
          "-9], upper = [9, 9] }\n";
      EXPECT_NEAR(at_rest(text)->integrals().strain_energy * 2 * (lambda + mu), 1, bar)
          << method << degrees;
    }
  }
}

}  // namespace
}  // namespace pliant::test::inclined
