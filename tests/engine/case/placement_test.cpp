#include "engine/case/placement.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/engine/case/written_case.hpp"

// Warnings about walls, loads and blades that have no effect because of their position.
namespace pliant {
namespace {

using tests::block_case;
using tests::complaint;
using tests::read_text;

std::string boundary(std::string_view keys, std::string_view geometry) {
  return fmt::format("[[boundary]]\nname = \"it\"\n{}\ngeometry = {{ {} }}\n", keys, geometry);
}

/// The first warning about the block, 1 x 2 with a spacing of 0.1, with `added` text.
std::string warning(const std::string& added, const std::string& method = "total_lagrangian") {
  const auto found = placement_warnings(
      read_text(fmt::format("method = \"{}\"\n{}{}", method, block_case, added)));
  return found.empty() ? "" : found.front();
}

constexpr std::string_view left = "shape = \"half_space\", point = [0, 0], normal = [1, 0]";
constexpr std::string_view far = "shape = \"half_space\", point = [-1, 0], normal = [1, 0]";
constexpr std::string_view sliver = "shape = \"box\", lower = [0.9999, 0], upper = [5, 0.01]";
constexpr std::string_view inside = "shape = \"box\", lower = [0.4, 0.8], upper = [0.6, 1.2]";
constexpr std::string_view pull = "kind = \"traction\"\ntraction = [1, 0]";

TEST(placement, walls_and_loads_that_touch_a_body_are_not_mentioned) {
  for (const std::string_view kind : {"fixed", "slip_wall"}) {
    EXPECT_EQ(warning(boundary(fmt::format("kind = \"{}\"", kind), left)), "");
  }
  EXPECT_EQ(warning(boundary("kind = \"fixed\"", sliver)), "");
  EXPECT_EQ(warning(boundary(pull, left)), "");
  EXPECT_EQ(warning(boundary(pull, sliver)), "");
  EXPECT_EQ(warning(boundary("kind = \"contact_wall\"", far)), "");
}

TEST(placement, a_wall_that_touches_no_body_holds_nothing) {
  EXPECT_EQ(warning(boundary("kind = \"fixed\"", far)),
            "the wall `it` touches no body at the start, so that it holds nothing; move it, or "
            "write kind = \"contact_wall\" for bodies that meet it later");
}

// The block begins at x = 0.
TEST(placement, a_gap_before_a_wall_is_mentioned) {
  const auto gap = [](double spacings) {
    return warning(boundary(
        "kind = \"fixed\"",
        fmt::format("shape = \"half_space\", point = [{}, 0], normal = [1, 0]", -0.1 * spacings)));
  };
  EXPECT_EQ(gap(0), "");
  EXPECT_EQ(gap(0.001), "");
  EXPECT_EQ(gap(-0.5), "");
  const std::string there = gap(0.3);
  EXPECT_TRUE(there.starts_with("the wall `it` is 0.3 spacings (")) << there;
  EXPECT_TRUE(
      there.ends_with(" m) away from the nearest body: walls hold bodies up to half a "
                      "spacing away, and perhaps not beyond; let them touch"))
      << there;
}

TEST(placement, an_overlap_with_a_contact_wall_is_mentioned) {
  const auto overlap = [](double spacings) {
    return warning(boundary(
        "kind = \"contact_wall\"",
        fmt::format("shape = \"half_space\", point = [{}, 0], normal = [1, 0]", 0.1 * spacings)));
  };
  EXPECT_EQ(overlap(0), "");
  EXPECT_EQ(overlap(-3), "");
  EXPECT_EQ(overlap(0.001), "");
  EXPECT_TRUE(overlap(0.02).starts_with(
      "body `block` overlaps the contact wall `it` by 0.02 spacings (0.002 m) at the start"))
      << overlap(0.02);
}

// Loads act within a millionth of the coordinates of a place.
TEST(placement, a_region_just_outside_a_body_loads_nothing) {
  const auto is_mentioned = [](double gap) {
    return !warning(boundary(pull, fmt::format("shape = \"half_space\", point = [{}, 0], "
                                               "normal = [1, 0]",
                                               -gap)))
                .empty();
  };
  EXPECT_FALSE(is_mentioned(1e-7));
  EXPECT_TRUE(is_mentioned(1e-4));
  EXPECT_TRUE(is_mentioned(0.03));
}

TEST(placement, a_region_without_a_surface_loads_nothing) {
  const std::string expected =
      "the region of `it` holds no surface of a body at the start, so that it loads nothing; let "
      "its geometry reach across a surface";
  EXPECT_EQ(warning(boundary(pull, far)), expected);
  EXPECT_EQ(warning(boundary(pull, inside)), expected);
  EXPECT_EQ(warning(boundary("kind = \"pressure\"\npressure = 1", inside)), expected);
}

std::string blade(std::string_view from, std::string_view path) {
  return fmt::format("[[cut]]\nname = \"blade\"\nfrom = {}\npath = {}\nstart = 0.1\nend = 0.5\n",
                     from, path);
}

const std::string soft =
    "method = \"point_based\"\n" + tests::with(block_case, "\"linear\"", "\"neo_hookean\"");

TEST(placement, a_blade_that_passes_beside_its_body_cuts_nothing) {
  const auto warnings = [](std::string_view from) {
    return placement_warnings(read_text(soft + blade(from, "[0, \"-6*(t - 0.1)\"]")));
  };
  EXPECT_TRUE(warnings("[0.5, 2.2]").empty());
  ASSERT_EQ(warnings("[1.5, 2.2]").size(), 1u);
  EXPECT_EQ(warnings("[1.05, 2.2]").size(), 1u);
  EXPECT_EQ(warnings("[1, 2.2]").size(), 1u) << "along the surface";
  EXPECT_EQ(warnings("[1.5, 2.2]").front(),
            "the cut `blade` never meets body `block`; its path is a displacement, from where the "
            "edge is at the start, in the undeformed body");
}

TEST(placement, what_moves_starts_where_the_case_puts_it) {
  EXPECT_EQ(complaint(soft + blade("[0.5, 2.2]", "[0, \"-6*t\"]")),
            "block.toml:14: the path of cut \"blade\" is -0.6 along y at t = 0.1, when it starts; "
            "write \"-6*t - (-0.6)\", or start from another place");
  EXPECT_EQ(
      complaint(block_case + boundary("kind = \"moving_wall\"\ndisplacement = [\"1/t\", 0]", left)),
      "block.toml:13: the displacement of wall \"it\" has no finite value along x at t = 0, "
      "when it starts; give a formula that is zero there");
  EXPECT_EQ(complaint(block_case +
                      boundary("kind = \"moving_wall\"\ndisplacement = [\"0.1*cos(t)\", 0]", left)),
            "block.toml:13: the displacement of wall \"it\" is 0.1 along x at t = 0, when it "
            "starts; write \"0.1*cos(t) - (0.1)\", or start from another place");
  EXPECT_EQ(complaint("method = \"total_lagrangian\"\n" + block_case +
                      boundary("kind = \"moving_wall\"\nrotation = { angle = \"1 + t\" }", left)),
            "block.toml:14: the angle of wall \"it\" is 1 at t = 0; write angle = \"1 + t - (1)\"");
}

TEST(placement, bodies_that_touch_without_a_contact_do_not_act_on_each_other) {
  const auto second = [](std::string_view lower, std::string_view contact) {
    return fmt::format(
        "[[body]]\nname = \"top\"\ngeometry = {{ shape = \"box\", lower = [0, {}], upper = [1, 3] "
        "}}\nmaterial = {{ model = \"linear\", youngs_modulus = 100, poissons_ratio = 0.3, density "
        "= "
        "2 }}\n{}",
        lower, contact);
  };
  const std::string expected =
      "bodies `block` and `top` touch at the start, and no [[contact]] names them both, so that "
      "they neither push nor hold each other; add one (kind = \"tied\" joins them)";
  EXPECT_EQ(warning(second("2", "")), expected);
  EXPECT_EQ(warning(second("1.5", "")), expected);
  EXPECT_EQ(warning(second("2.05", "")), "");
  EXPECT_EQ(warning(second("2", "[[contact]]\nbodies = [\"top\", \"block\"]\n")), "");
}

TEST(placement, contact_walls_turn_in_methods_on_the_undeformed_body) {
  const auto turning = [](const std::string& kind) {
    return block_case + boundary("kind = \"" + kind + "\"\nrotation = { angle = \"t\" }", left);
  };
  EXPECT_EQ(complaint("method = \"total_lagrangian\"\n" + turning("contact_wall")), "");
  EXPECT_EQ(complaint(turning("moving_wall")), "");
  EXPECT_EQ(complaint(turning("contact_wall")),
            "block.toml:13: method \"remeshed\" has no contact walls that turn; take method = "
            "\"total_lagrangian\", or remove the key");
}

}  // namespace
}  // namespace pliant
