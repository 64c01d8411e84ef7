#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/undeformed/inclined.hpp"

// Rings and hollow balls around rigid cores, compared with Lame's solutions.
namespace pliant::test::inclined {
namespace {

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
TEST(cores, in_a_ring_or_ball_hold_it_where_it_is) {
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
        // Of quadratic fits; linear ones, which are several times worse inside, had 0.129 and
        // 0.0149.
        const double coarse = method == "point_based" ? 0.14 : 0.13;
        const double fine = method == "point_based" ? 0.017 : 0.015;
        EXPECT_LT(errors.stress, dimension == 3 ? coarse : fine);
      }
    }
  }
}

// A ring is twisted by a traction along its rim: it turned 3 to 16 % too far in the point-based
// method.
TEST(cores, hold_a_ring_that_is_twisted) {
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

}  // namespace
}  // namespace pliant::test::inclined
