#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Bars with few spacings across between walls that turn: what is off, and that it is told.
namespace pliant::test {
namespace {

constexpr double modulus = 100, ratio = 0.3, bar_length = 4;

std::string bar_between_walls(const std::string& head, const std::string& geometry,
                              const std::string& rest) {
  return fmt::format(
             "{}\ntime.end = 10\ndiscretisation.damping = \"adaptive\"\n[[body]]\nname = \"bar\"\n"
             "geometry = {}\nmaterial = {{ model = \"neo_hookean\", density = 1, youngs_modulus = "
             "{}, poissons_ratio = {} }}\n",
             head, geometry, modulus, ratio) +
         rest;
}

/// A bar of a diameter of 1 m that is twisted by 0.1 rad.
std::string twisted_bar(const std::string& method, bool is_round, int across) {
  const std::string box = fmt::format(
      "{{ shape = \"box\", lower = [0, -0.5, -0.5], upper = [{}, 0.5, 0.5] }}", bar_length);
  const std::string rod =
      "{ shape = \"intersection\", of = [{ shape = \"cylinder\", centre = [0, 0, 0], axis = [1, 0, "
      "0], radius = 0.5 }, " +
      box + "] }";
  const std::string middle = fmt::format("[{}, 0, 0]", bar_length);
  return bar_between_walls(
      fmt::format("method = \"{}\"\ndimension = 3\ndiscretisation.spacing = {}", method,
                  1.0 / across),
      is_round ? rod : box,
      half_space("base", "kind = \"fixed\"", "[0, 0, 0]", "[1, 0, 0]") +
          half_space("head",
                     "kind = \"moving_wall\"\nrotation = { centre = " + middle +
                         ", axis = [1, 0, 0], angle = \"0.1*min(t, 1)\" }",
                     middle, "[-1, 0, 0]") +
          measurement(
              "moment",
              "kind = \"wall_moment\"\nboundary = \"head\"\naxis = \"x\"\npoint = " + middle));
}

/// A strip of 1 m that two walls bend by 0.1 rad.
std::string bent_strip(const std::string& nodes, int across) {
  const std::string middle = fmt::format("[{}, 0]", bar_length);
  return bar_between_walls(
      fmt::format("method = \"point_based\"\npoint_based.nodes = \"{}\"\ndimension = 2\n"
                  "discretisation.spacing = {}",
                  nodes, 1.0 / across),
      fmt::format("{{ shape = \"box\", lower = [0, -0.5], upper = [{}, 0.5] }}", bar_length),
      half_space("base", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
          half_space("head",
                     fmt::format("kind = \"moving_wall\"\ndisplacement = [\"-{}*min(t, 1)\", "
                                 "\"{}*min(t, 1)\"]\nrotation "
                                 "= {{ centre = {}, angle = \"0.1*min(t, 1)\" }}",
                                 bar_length * 0.01 / 6, 0.05 * bar_length, middle),
                     middle, "[-1, 0]") +
          measurement("moment", "kind = \"wall_moment\"\nboundary = \"head\"\npoint = " + middle) +
          measurement("stress",
                      "kind = \"material_value\"\nfield = \"stress_xx\"\npoint = [2, "
                      "0.499]"));
}

struct RunOfBar {
  double moment = 0, stress = 0;
  std::string warnings;
};

RunOfBar run_of(const std::string& text) {
  const Case settings = tests::read_text(text);
  RunOfBar found;
  for (const std::string& warning : warnings_of_method(settings)) found.warnings += warning + "\n";
  const auto run = methods().make(settings, {});
  found.moment = mean_force(*run, "moment", 8, 10);
  found.stress = values(*run)["stress"];
  return found;
}

TEST(bars_of_few_spacings, are_warned_of_where_twisting_them_takes_another_moment) {
  const double shear_modulus = modulus / 2 / (1 + ratio), turn = 0.1 / bar_length;
  const double square = 0.140577 * shear_modulus * turn;  // Saint-Venant
  const double round = std::numbers::pi / 32 * shear_modulus * turn;
  const RunOfBar cells = run_of(twisted_bar("total_lagrangian", false, 4));
  EXPECT_NEAR(cells.moment / square, 1.08, 0.01);
  EXPECT_NE(cells.warnings.find("up to 9 % too much moment"), std::string::npos) << cells.warnings;
  const RunOfBar more = run_of(twisted_bar("total_lagrangian", false, 8));
  EXPECT_NEAR(more.moment / square, 1.027, 0.005);
  EXPECT_EQ(more.warnings.find("twist"), std::string::npos) << more.warnings;
  const RunOfBar points = run_of(twisted_bar("point_based", true, 4));
  EXPECT_NEAR(points.moment / round, 0.94, 0.01);
  EXPECT_NE(points.warnings.find("forces deviate by up to 8 %"), std::string::npos)
      << points.warnings;
  const RunOfBar finer = run_of(twisted_bar("point_based", true, 8));
  EXPECT_NEAR(finer.moment / round, 1, 0.01);
  EXPECT_EQ(finer.warnings, "");
}

TEST(bars_of_few_spacings, are_warned_of_where_bending_or_its_stress_deviates) {
  const double plane_modulus = modulus / (1 - ratio * ratio), curvature = 0.1 / bar_length;
  const double moment = plane_modulus * curvature / 12, stress = -plane_modulus * curvature / 2;
  const RunOfBar lattice = run_of(bent_strip("lattice", 4));
  EXPECT_NEAR(lattice.moment / moment, 1, 0.02);
  EXPECT_NEAR(lattice.stress / stress, 0.9, 0.015);
  EXPECT_NE(lattice.warnings.find("stresses near its surface are up to 12 % too small"),
            std::string::npos)
      << lattice.warnings;
  const RunOfBar finer = run_of(bent_strip("lattice", 12));
  EXPECT_NEAR(finer.stress / stress, 0.97, 0.01);
  EXPECT_EQ(finer.warnings, "");
  const RunOfBar octree = run_of(bent_strip("octree", 6));
  EXPECT_NEAR(octree.moment / moment, 1.1, 0.02);
  EXPECT_NE(octree.warnings.find("bends up to 16 % too little"), std::string::npos)
      << octree.warnings;
}

}  // namespace
}  // namespace pliant::test
