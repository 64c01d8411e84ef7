#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

/// Warnings of a square of 1 m, turned by an angle with this tangent, of which a displacement is
/// measured at a point.
std::vector<std::string> warnings_at(const std::string& method, double tangent,
                                     const std::string& point) {
  const double c = 1 / std::sqrt(1 + tangent * tangent), s = tangent * c;
  std::string faces;
  for (const auto& [x, y, distance] :
       {std::array{c, s, 1.}, {-c, -s, 0.}, {-s, c, 1.}, {s, -c, 0.}}) {
    faces += fmt::format("{{ shape = \"half_space\", point = [{}, {}], normal = [{}, {}] }}, ",
                         distance * x, distance * y, x, y);
  }
  const auto warnings = warnings_of_method(tests::read_text(fmt::format(
      R"(method = "{}"
dimension = 2
discretisation = {{ spacing = 0.05 }}
time = {{ end = 1 }}
[[body]]
name = "square"
material = {{ model = "neo_hookean", density = 1, youngs_modulus = 1, poissons_ratio = 0.3 }}
geometry = {{ shape = "intersection", of = [{}{{ shape = "box", lower = [-2, -2], upper = [2, 2] }}] }}
[[measurement]]
name = "moved"
kind = "point_displacement"
point = {}
)",
      method, faces, point)));
  std::vector<std::string> of_edges;
  for (const std::string& warning : warnings) {
    if (warning.find("at an angle to the axes") != std::string::npos) of_edges.push_back(warning);
  }
  return of_edges;
}

// Stresses at corners of turned blocks are up to 40 % off in the total Lagrangian method.
TEST(measured_edges, are_warned_of_at_an_angle_to_the_axes) {
  ASSERT_EQ(warnings_at("total_lagrangian", 0.75, "[0.2, 1.4]").size(), 1u);
  EXPECT_NE(warnings_at("total_lagrangian", 0.75, "[0.2, 1.4]")[0].find("`moved` is taken"),
            std::string::npos);
  EXPECT_TRUE(warnings_at("total_lagrangian", 0.75, "[0.1, 0.7]").empty());   // inside
  EXPECT_TRUE(warnings_at("total_lagrangian", 0.75, "[-0.2, 1.1]").empty());  // on a face
  EXPECT_TRUE(warnings_at("total_lagrangian", 0, "[1, 1]").empty());
  EXPECT_TRUE(warnings_at("point_based", 0.75, "[0.2, 1.4]").empty());
}

}  // namespace
}  // namespace pliant::test
