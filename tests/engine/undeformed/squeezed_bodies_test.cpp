#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/undeformed/squeezed_bodies.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Coarse cubes of nearly incompressible material push back too hard where walls squeeze them.
namespace pliant::test {
namespace {

std::size_t warnings(const std::string& velocity, const std::string& ratio,
                     const std::string& spacing) {
  static constexpr ThinBodyError errors[] = {{6.5, "forces are too large"}};
  const Case settings = tests::read_text(
      "dimension = 3\nmethod = \"total_lagrangian\"\ntime.end = 1\ndiscretisation.spacing = " +
      spacing + R"toml(
[[body]]
name = "cube"
geometry = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] }
material = { model = "neo_hookean", youngs_modulus = 100, density = 1, poissons_ratio = )toml" +
      ratio + " }\n" + half_space("floor", "kind = \"fixed\"", "[0, 0, 0]", "[0, 0, 1]") +
      half_space("upper", "kind = \"moving_wall\"\nvelocity = [0, 0, \"" + velocity + "\"]",
                 "[0, 0, 1]", "[0, 0, -1]"));
  std::vector<std::string> found;
  undeformed::warn_of_squeezed_bodies(settings, errors, found);
  return found.size();
}

TEST(squeezed_bodies, are_warned_of_if_they_are_coarse_and_nearly_incompressible) {
  EXPECT_EQ(warnings("-0.1", "0.45", "0.167"), 1);
  EXPECT_EQ(warnings("0.1", "0.45", "0.167"), 0);
  EXPECT_EQ(warnings("0.1*cos(20*t)", "0.45", "0.167"), 1);
  EXPECT_EQ(warnings("-0.1", "0.3", "0.167"), 0);
  EXPECT_EQ(warnings("-0.1", "0.45", "0.1"), 0);
}

}  // namespace
}  // namespace pliant::test
