#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "engine/case/checks/tools.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Rigid tools that are pressed into a block on a fixed floor, (TL.35).
namespace pliant::test {
namespace {

struct Pressing {
  std::string method;
  int across;  ///< spacings in 1 m
  double deviation;
};

/// A block of neo-Hookean rubber, 1 m high and 2 m wide in 2D, 0.5 m high and 1 m wide in 3D, and a
/// tool of this geometry that touches its top and comes down by `depth` in 2 s.
std::string pressed_block(int dimension, const std::string& tool, double depth,
                          const Pressing& setting) {
  const bool flat = dimension == 2;
  return fmt::format(
             R"toml(dimension = {}
method = "{}"
discretisation.spacing = "1/{}"
discretisation.damping = "adaptive"
time.end = 4
[[body]]
name = "block"
geometry = {{ shape = "box", {} }}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.4, density = 1 }}
[[boundary]]
name = "tool"
kind = "contact_wall"
displacement = {}
geometry = {}
)toml",
             dimension, setting.method, setting.across,
             flat ? "lower = [-1, 0], upper = [1, 1]"
                  : "lower = [-0.5, -0.5, 0], upper = [0.5, 0.5, 0.5]",
             fmt::format("[{} \"-{}*min(t/2, 1)\"]", flat ? "0," : "0, 0,", depth), tool) +
         (flat ? half_space("floor", "kind = \"fixed\"", "[0, 0]", "[0, 1]")
               : half_space("floor", "kind = \"fixed\"", "[0, 0, 0]", "[0, 0, 1]")) +
         measurement("force",
                     fmt::format("kind = \"wall_force\"\nboundary = \"tool\"\naxis = \"{}\"",
                                 flat ? "y" : "z"));
}

/// Expects the force [N], or N/m in 2D, and that no energy is created.
void expect_force(double expected, int dimension, const std::string& tool, double depth,
                  std::initializer_list<Pressing> settings) {
  for (const Pressing& setting : settings) {
    SCOPED_TRACE(fmt::format("{}, {}", setting.method, setting.across));
    const auto run =
        methods().make(tests::read_text(pressed_block(dimension, tool, depth, setting)),
                       {2, kernels::widest_supported()});
    EXPECT_NEAR(-mean_force(*run, "force", 3.5, 4), expected, setting.deviation * expected);
    EXPECT_LT(std::abs(balance(*run)), 0.03 * run->energy_budget()->wall_work);
  }
}

// 13.33 N/m with 200 spacings in 1 m. If corners alone met the tool, it would be 0.55, 0.82 and
// 0.95 of that in the total Lagrangian method, and 0.65, 0.75 and 0.91 in the point-based one.
TEST(tools, of_two_to_six_spacings_press_with_the_force_of_a_flat_punch) {
  expect_force(13.33, 2, "{ shape = \"box\", lower = [-0.125, 1], upper = [0.125, 3] }", 0.15,
               {{"total_lagrangian", 8, 0.03},
                {"total_lagrangian", 16, 0.04},
                {"total_lagrangian", 25, 0.03},
                {"point_based", 8, 0.05},
                {"point_based", 16, 0.05},
                {"point_based", 25, 0.045}});
}

// 5.69 N with 40 spacings in 1 m. Corners alone: 0.58, 0.77 and 0.55, 0.86.
TEST(tools, press_with_the_force_of_a_round_flat_punch) {
  expect_force(5.69, 3,
               R"({ shape = "intersection", of = [
  { shape = "cylinder", centre = [0, 0, 0], radius = 0.2 },
  { shape = "box", lower = [-1, -1, 0.5], upper = [1, 1, 2] }] })",
               0.08,
               {{"total_lagrangian", 10, 0.08},
                {"total_lagrangian", 16, 0.02},
                {"point_based", 10, 0.08},
                {"point_based", 16, 0.04}});
}

// 2.585 N with 40 spacings in 1 m. Corners alone: 0.89, 0.95 and 0.91, 0.95.
TEST(tools, press_with_the_force_of_a_ball) {
  expect_force(2.585, 3, "{ shape = \"ball\", centre = [0, 0, 0.8], radius = 0.3 }", 0.08,
               {{"total_lagrangian", 10, 0.035},
                {"total_lagrangian", 15, 0.025},
                {"point_based", 10, 0.045},
                {"point_based", 15, 0.015}});
}

// 0.2224 N/m with 100 spacings in 1 m. Without the shares of (TL.35) at the ends of edges: 0.21,
// 0.68, 0.94 and 1.04.
TEST(tools, that_barely_touch_press_with_the_force_of_a_disc) {
  expect_force(0.2224, 2, "{ shape = \"disc\", centre = [0, 1.3], radius = 0.3 }", 0.005,
               {{"total_lagrangian", 8, 0.07},
                {"total_lagrangian", 10, 0.09},
                {"total_lagrangian", 13, 0.12},
                {"total_lagrangian", 26, 0.03}});
}

/// A beam on two discs that a third one bends.
std::string bent_beam(const std::string& method, int across, double aside) {
  std::string text = fmt::format(R"toml(dimension = 2
method = "{}"
discretisation.spacing = "1/{}"
discretisation.damping = "adaptive"
time.end = 6
[[body]]
name = "beam"
geometry = {{ shape = "box", lower = [-2.6, -0.5], upper = [2.6, 0.5] }}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 0.01 }}
)toml",
                                 method, across);
  const auto add_disc = [&](const char* name, double x, double y, const char* down) {
    text += fmt::format(R"toml([[boundary]]
name = "{}"
kind = "contact_wall"
displacement = [0, "{}"]
geometry = {{ shape = "disc", centre = [{}, {}], radius = 0.5 }}
)toml",
                        name, down, x + aside, y);
  };
  add_disc("left", -2, -1, "0");
  add_disc("right", 2, -1, "0");
  add_disc("middle", 0, 1, "-0.1*min(t/3, 1)");
  return text + measurement("force", "kind = \"wall_force\"\nboundary = \"middle\"\naxis = \"y\"");
}

// 0.551 N/m with 32 spacings across. Without these shares 0.72, 0.95, 0.99 and 0.68, 0.93, 1.00.
TEST(tools, bend_a_beam_on_two_supports) {
  for (const auto& [method, across, deviation] :
       {Pressing{"total_lagrangian", 4, 0.14}, Pressing{"total_lagrangian", 6, 0.02},
        Pressing{"total_lagrangian", 8, 0.025}, Pressing{"point_based", 4, 0.18},
        Pressing{"point_based", 6, 0.025}, Pressing{"point_based", 8, 0.035}}) {
    SCOPED_TRACE(fmt::format("{}, {}", method, across));
    const auto run = methods().make(tests::read_text(bent_beam(method, across, 0.013)),
                                    {2, kernels::widest_supported()});
    EXPECT_NEAR(-mean_force(*run, "force", 5, 6), 0.551, deviation * 0.551);
  }
}

// 15.36 N/m with 100 spacings in 1 m. Corners alone: 0.84, 0.98 and 0.38, 0.70, as they slide
// around the tool.
TEST(tools, of_a_radius_below_two_spacings_press_deeper_than_it) {
  expect_force(15.36, 2, "{ shape = \"capsule\", from = [0, 1.15], to = [0, 3], radius = 0.15 }",
               0.2,
               {{"total_lagrangian", 10, 0.04},
                {"total_lagrangian", 16, 0.02},
                {"point_based", 10, 0.04},
                {"point_based", 16, 0.02}});
}

TEST(tools, are_warned_of_where_they_are_narrow) {
  static constexpr NarrowToolError edged[] = {{4.1, 30}, {8.5, 13}}, round[] = {{4, 16}},
                                   attached[] = {{6, 8}};
  const auto warnings_of = [&](const std::string& tool, int across,
                               const std::string& kind = "contact_wall") {
    std::vector<std::string> warnings;
    std::string text = pressed_block(2, tool, 0.1, {"total_lagrangian", across, 0});
    text.replace(text.find("contact_wall"), 12, kind);
    warn_of_narrow_tools(tests::read_text(text), {edged, round, attached}, warnings);
    return warnings;
  };
  const std::string punch = "{ shape = \"box\", lower = [-0.25, 1], upper = [0.25, 3] }";
  ASSERT_EQ(warnings_of(punch, 10).size(), 1U);
  EXPECT_EQ(warnings_of(punch, 10)[0],
            "the wall `tool` is 5 spacings wide: its force deviates by up to 13 %; use a finer "
            "spacing (discretisation.spacing = 0.0588 or below)");
  EXPECT_EQ(warnings_of(punch, 10, "moving_wall").size(), 1U);
  EXPECT_TRUE(warnings_of(punch, 13, "moving_wall").empty());
  EXPECT_TRUE(warnings_of(punch, 20).empty());
  // However far they reach beyond the body.
  const std::string corner = "{ shape = \"box\", lower = [-9, -9], upper = [-0.6, 0.3] }";
  EXPECT_EQ(warnings_of(corner, 10, "moving_wall").size(), 1U);
  EXPECT_TRUE(warnings_of(corner, 20, "moving_wall").empty());
  const std::string end = "{ shape = \"box\", lower = [-9, -9], upper = [-0.3, 9] }";
  EXPECT_TRUE(warnings_of(end, 10, "moving_wall").empty());
  const std::string plate = "{ shape = \"box\", lower = [-1, 1], upper = [1, 1.1] }";
  EXPECT_TRUE(warnings_of(plate, 10).empty());
  const std::string disc = "{ shape = \"disc\", centre = [0, 1.2], radius = 0.2 }";
  EXPECT_EQ(warnings_of(disc, 9).size(), 1U);
  EXPECT_TRUE(warnings_of(disc, 11).empty());
  EXPECT_TRUE(warnings_of(disc, 9, "moving_wall").empty());
}

TEST(tools, are_warned_of_in_the_remeshed_method) {
  const auto warnings_of = [&](const std::string& tool) {
    std::vector<std::string> warnings;
    warn_of_tools(tests::read_text(pressed_block(2, tool, 0.1, {"remeshed", 10, 0})),
                  "its force is too small", warnings);
    return warnings;
  };
  EXPECT_EQ(warnings_of("{ shape = \"disc\", centre = [0, 2], radius = 1 }").size(), 1U);
  EXPECT_TRUE(warnings_of("{ shape = \"half_space\", point = [0, 1], normal = [0, -1] }").empty());
}

}  // namespace
}  // namespace pliant::test
