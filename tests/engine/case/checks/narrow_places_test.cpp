#include "engine/case/checks/narrow_places.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/case/written_case.hpp"

namespace pliant {
namespace {

constexpr ThinBodyError errors[] = {{2, "large"}, {3, "small"}};
const std::string block = "{ shape = \"box\", lower = [-2, -2], upper = [2, 2] }";

Case body_of(const std::string& kind, const std::string& part, const std::string& added = "") {
  return tests::read_text(
      "dimension = 2\n[discretisation]\nspacing = 0.1\n[time]\nend = 1\n[[body]]\nname = \"it\"\n"
      "geometry = { shape = \"" +
      kind + "\", of = [" + block + ", " + part +
      "] }\nmaterial = { model = \"linear\", youngs_modulus = 1, poissons_ratio = 0.3, density = 1 "
      "}\n" +
      added);
}

using Warnings = std::vector<std::string>;

Warnings gaps_of(const std::string& slot) {
  Warnings warnings;
  warn_of_narrow_gaps(body_of("difference", slot), errors, warnings);
  return warnings;
}

Warnings parts_of(const std::string& fin, const std::string& added = "") {
  Warnings warnings;
  warn_of_thin_parts(body_of("union", fin, added), errors, warnings);
  return warnings;
}

std::string box(const std::string& lower, const std::string& upper) {
  return "{ shape = \"box\", lower = [" + lower + "], upper = [" + upper + "] }";
}

/// A band of a width about the line from the middle of the block to its upper right corner.
std::string slanted(double width) {
  const auto side = [width](double sign) {
    return fmt::format("{{ shape = \"half_space\", point = [{0}, {1}], normal = [{0}, {1}] }}",
                       sign * width / std::sqrt(8), -sign * width / std::sqrt(8));
  };
  return "{ shape = \"intersection\", of = [" + side(1) + ", " + side(-1) + ", " +
         box("0, 0", "4, 4") + "] }";
}

TEST(narrow_places, gaps_are_warned_of) {
  EXPECT_EQ(gaps_of(box("0, 0", "0.15, 9")),
            Warnings{"body `it` has a gap of 1.5 spacings: large; use a finer spacing "
                     "(discretisation.spacing = 0.05 or below)"});
  EXPECT_EQ(gaps_of(box("0, 0", "0.25, 9")).size(), 1U);
  EXPECT_EQ(gaps_of(slanted(0.25)).size(), 1U);
  EXPECT_TRUE(gaps_of(box("0, 0", "0.35, 9")).empty());
  EXPECT_TRUE(gaps_of(slanted(0.35)).empty());
}

// A step and a notch of 45 degrees have no faces that are opposite to each other.
TEST(narrow_places, corners_are_none) {
  EXPECT_TRUE(gaps_of(box("0, 0", "9, 9")).empty());
  EXPECT_TRUE(gaps_of("{ shape = \"intersection\", of = [" + box("0, 0", "9, 9") +
                      ", { shape = \"half_space\", point = [0, 0], normal = [-1, 1] }] }")
                  .empty());
}

TEST(narrow_places, thin_parts_are_warned_of) {
  EXPECT_EQ(parts_of(box("0, 0", "5, 0.15")),
            Warnings{"body `it` has a part 1.5 spacings thick: large; use a finer spacing "
                     "(discretisation.spacing = 0.05 or below)"});
  EXPECT_EQ(parts_of(box("0, 0", "5, 0.25")).size(), 1U);
  EXPECT_TRUE(parts_of(box("0, 0", "5, 0.35")).empty());
}

TEST(narrow_places, parts_that_walls_hold_are_none) {
  EXPECT_TRUE(parts_of(box("0, 0", "5, 0.15"),
                       "[[boundary]]\nname = \"wall\"\nkind = \"fixed\"\ngeometry = " +
                           box("2, -1", "9, 1") + "\n")
                  .empty());
}

}  // namespace
}  // namespace pliant
