#include "engine/point_based/cutting/cut_resolution.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "engine/simulation/methods.hpp"

namespace pliant::test {
namespace {

std::string said_of(const std::vector<std::string>& settings) {
  std::vector<std::string> warnings;
  const Case a_case = read_case(PLIANT_SOURCE_DIR "/cases/edge_cut", settings);
  point_based::warn_of_coarse_cuts(a_case, warnings);
  return fmt::format("{}", fmt::join(warnings, "\n"));
}

std::string said_of(const std::string& spacing, const std::string& rule) {
  return said_of({"discretisation.spacing=" + spacing, "point_based.cut_rule=" + rule});
}

// Fracture theory gives the opening; the blade goes from x = -0.05 to 0.5. With spacings of 1/15
// and 1/20 the plate opens by 10 % and 5 % too little; with 1/27 and visibility, by 9 % too much.
TEST(resolution, of_a_cut_by_few_spacings_is_said_to_be_too_coarse) {
  EXPECT_NE(said_of("1/15", "transparency").find("the cut `blade` advances by 8.2 spacings"),
            std::string::npos);
  EXPECT_EQ(said_of("1/20", "transparency"), "");
  EXPECT_NE(said_of("1/27", "visibility").find("cut_rule = \"transparency\""), std::string::npos);
}

// A complete cut of a plate of 20 x 8 nodes does not divide it.
TEST(resolution, by_products_is_said_to_leave_bonds) {
  EXPECT_NE(said_of("1/20", "product").find("may not divide the body"), std::string::npos);
}

TEST(resolution, of_a_blade_that_goes_back_or_round_is_that_of_how_far_it_comes) {
  const std::string to_and_fro = R"toml(cut.0.path=["0.55*sin(pi*t/2)", 0])toml";
  EXPECT_EQ(said_of({to_and_fro}), "");
  const std::string round = R"toml(cut.0.path=["0.1*(cos(pi*t) - 1)", "0.1*sin(pi*t)"])toml";
  EXPECT_NE(said_of({round}).find("advances by 4 spacings"), std::string::npos);
}

TEST(resolution, of_a_blade_that_stays_is_none_unless_a_program_moves_it) {
  EXPECT_NE(said_of({"cut.0.path=[0, 0]"}).find("stays where it starts"), std::string::npos);
  EXPECT_EQ(said_of({"cut.0.path=[0, 0]", "cut.0.start=200", "cut.0.end=300"}), "");
}

// In block_cut the edge of the blade lies along z.
TEST(resolution, of_a_blade_that_moves_along_its_edge_is_none) {
  const auto said = [](const std::string& path) {
    std::vector<std::string> warnings;
    const std::vector<std::string> settings = {"cut.0.path=" + path};
    const Case a_case = read_case(PLIANT_SOURCE_DIR "/cases/block_cut", settings);
    point_based::warn_of_coarse_cuts(a_case, warnings);
    return fmt::format("{}", fmt::join(warnings, "\n"));
  };
  const std::string start = "0.1*(t - 0.08)";
  EXPECT_NE(said("[0, 0, \"" + start + "\"]").find("moves along its own edge only"),
            std::string::npos);
  EXPECT_EQ(said("[0, \"" + start + "\", \"" + start + "\"]").find("moves along"),
            std::string::npos);
}

}  // namespace
}  // namespace pliant::test
