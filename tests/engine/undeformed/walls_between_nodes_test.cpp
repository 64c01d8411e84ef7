#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/engine/undeformed/inclined.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Walls along the lattice that lie anywhere between two rows of nodes.
namespace pliant::test {
namespace {

using inclined::at_rest;

/// A block of 1 m without lateral contraction that a wall holds below the height `held`.
std::string held_block(const std::string& method, int dimension, int across, double held) {
  const bool plane = dimension == 2;
  return fmt::format(
             R"toml(dimension = {}
method = "{}"
discretisation.spacing = "1/{}"
discretisation.damping = "adaptive"
time.end = 4
[[body]]
name = "block"
geometry = {{ shape = "box", lower = {}, upper = {} }}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0, density = 1 }}
)toml",
             dimension, method, across, plane ? "[0, 0]" : "[0, 0, 0]",
             plane ? "[1, 1]" : "[1, 1, 1]") +
         half_space("floor", "kind = \"fixed\"",
                    plane ? fmt::format("[0, {}]", held) : fmt::format("[0, 0, {}]", held),
                    plane ? "[0, 1]" : "[0, 0, 1]");
}

std::string name_of(double height) { return fmt::format("at{:.0f}", 100 * height); }

/// The largest deviation of a displacement over the exact one, of points from 0.25 m to 0.9 m above
/// the wall, under a pull of E/1000.
double deviation(const std::string& method, int dimension, int across, double held) {
  const bool plane = dimension == 2;
  std::string text =
      held_block(method, dimension, across, held) +
      "[[boundary]]\nname = \"pull\"\nkind = \"pressure\"\npressure = "
      "-0.1\ngeometry = { shape = \"box\", lower = " +
      (plane ? "[-9, 0.9999], upper = [9, 9]" : "[-9, -9, 0.9999], upper = [9, 9, 9]") + " }\n";
  const std::vector<double> heights = {0.25, 0.35, 0.5, 0.6, 0.8};
  for (const double height : heights) {
    text += measurement(
        name_of(height),
        fmt::format("kind = \"point_displacement\"\naxis = \"{}\"\npoint = {}", plane ? "y" : "z",
                    plane ? fmt::format("[0.5, {}]", held + height)
                          : fmt::format("[0.5, 0.5, {}]", held + height)));
  }
  const auto solver = at_rest(text);
  solver->advance(4);
  auto found = values(*solver);
  double most = 0;
  for (const double height : heights) {
    most = std::max(most, std::abs(found[name_of(height)] / (1e-3 * height) - 1));
  }
  return most;
}

// The part in the wall has no stress and no strain: means over the body are 0.8 of those of the
// part above. By points they were 1.12 of that.
TEST(walls_between_nodes, leave_the_part_in_them_out_of_mean_stresses) {
  const std::string whole =
      "gravity = [0, \"-0.1\"]\n" + held_block("total_lagrangian", 2, 10, 0.2) +
      measurement("stress", "kind = \"mean_value\"\nfield = \"stress_yy\"\n") +
      measurement("strain", "kind = \"mean_value\"\nfield = \"strain_yy\"\n");
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    SCOPED_TRACE(method);
    const auto solver = at_rest(tests::with(whole, "total_lagrangian", method));
    solver->advance(4);
    auto found = values(*solver);
    EXPECT_NEAR(found["stress"], -0.032, 0.01 * 0.032);
    EXPECT_NEAR(found["strain"], -0.00032, 0.01 * 0.00032);
  }
}

// Rows of points moved to and fro in turn, by up to half of the strain, and stayed 0.04 m behind.
TEST(walls_between_nodes, hold_a_block_where_they_are) {
  for (const double share : {0.1, 0.3, 0.45, 0.52, 0.6, 0.75, 0.9}) {
    SCOPED_TRACE(share);
    EXPECT_LT(deviation("total_lagrangian", 2, 10, share / 10), 0.001);
    EXPECT_LT(deviation("point_based", 2, 10, share / 10), 0.04);
    EXPECT_LT(deviation("point_based", 2, 14, share / 14), 0.03);
  }
  for (const double share : {0.3, 0.52, 0.75}) {
    SCOPED_TRACE(share);
    EXPECT_LT(deviation("total_lagrangian", 3, 6, share / 6), 0.002);
    EXPECT_LT(deviation("point_based", 3, 6, share / 6), 0.06);
  }
}

// A facet whose middle is behind the wall bore nothing.
TEST(walls_between_nodes, take_what_acts_on_the_face_beside_them) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    for (const double held : {0.03, 0.05, 0.07, 0.25}) {
      const auto solver =
          at_rest(held_block(method, 2, 10, held) +
                  "[[boundary]]\nname = \"push\"\nkind = \"traction\"\narea = "
                  "\"undeformed\"\ntraction = [0.1, 0]\ngeometry = { shape = \"box\", lower = "
                  "[0.999, -9], upper = [9, 9] }\n" +
                  measurement("force", "kind = \"wall_force\"\nboundary = \"floor\""));
      const double start = values(*solver)["force"], from = solver->clock().time;
      solver->advance(from + 1);
      const double force = (values(*solver)["force"] - start) / (solver->clock().time - from);
      EXPECT_NEAR(-force, 0.1 * (1 - held), 0.1 * 0.003) << method << " " << held;
    }
  }
}

}  // namespace
}  // namespace pliant::test
