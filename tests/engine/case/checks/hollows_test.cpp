#include "engine/case/checks/hollows.hpp"

#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

std::vector<std::string> warnings_of(const std::string& geometry, const std::string& added = "") {
  const Case a_case = tests::read_text(
      "dimension = 2\n[discretisation]\nspacing = 0.1\n[time]\nend = 1\n[[body]]\nname = \"it\"\n"
      "geometry = { shape = \"difference\", of = [{ shape = \"box\", lower = [-2, -2], upper = [2, "
      "2] }, " +
      geometry +
      "] }\nmaterial = { model = \"linear\", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 "
      "}\n" +
      added);
  constexpr ThinBodyError errors[] = {{4, "large"}, {8, "small"}};
  std::vector<std::string> warnings;
  warn_of_small_hollows(a_case, errors, warnings);
  return warnings;
}

TEST(hollows, with_a_small_radius_are_warned_of) {
  EXPECT_EQ(warnings_of("{ shape = \"disc\", centre = [0, 0], radius = 0.3 }"),
            std::vector<std::string>{"body `it` has a hole or a hollow with a radius of 3 "
                                     "spacings: large; use a finer spacing "
                                     "(discretisation.spacing = 0.0375 or below)"});
  EXPECT_EQ(warnings_of("{ shape = \"disc\", centre = [0, 0], radius = 0.5 }").size(), 1U);
  EXPECT_TRUE(warnings_of("{ shape = \"disc\", centre = [0, 0], radius = 0.8 }").empty());
}

TEST(hollows, are_round_and_at_the_body) {
  EXPECT_TRUE(warnings_of("{ shape = \"box\", lower = [-0.3, -0.3], upper = [0.3, 0.3] }").empty());
  EXPECT_TRUE(warnings_of("{ shape = \"disc\", centre = [5, 0], radius = 0.3 }").empty());
}

TEST(hollows, are_not_filled_by_walls) {
  const std::string hole = "{ shape = \"disc\", centre = [0, 0], radius = 0.3 }";
  EXPECT_TRUE(warnings_of(hole, "[[boundary]]\nname = \"core\"\nkind = \"fixed\"\ngeometry = " +
                                    hole + "\n")
                  .empty());
}

}  // namespace
}  // namespace pliant
