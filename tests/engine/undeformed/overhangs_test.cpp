#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/boundaries/overhanging_bodies.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Walls hold caps of round bodies, (TL.11), (PB.21): what is beyond the rim is next to a wall, but
// free.
namespace pliant::test {
namespace {

/// A disc or a ball of neo-Hookean rubber, 1 m across, of which a fixed wall holds the cap below
/// -0.35 m.
std::string round_body(int dimension, const std::string& method, int across, double end) {
  return fmt::format(
             R"toml(dimension = {}
method = "{}"
discretisation.spacing = "1/{}"
discretisation.damping = "adaptive"
time.end = {}
[[body]]
name = "round"
geometry = {{ shape = "{}", centre = {}, radius = 0.5 }}
material = {{ model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}
)toml",
             dimension, method, across, end, dimension == 2 ? "disc" : "ball",
             dimension == 2 ? "[0, 0]" : "[0, 0, 0]") +
         (dimension == 2 ? half_space("floor", "kind = \"fixed\"", "[0, -0.35]", "[0, 1]")
                         : half_space("floor", "kind = \"fixed\"", "[0, 0, -0.35]", "[0, 0, 1]"));
}

/// A wall that holds the cap above 0.35 m, and its impulse along an axis.
std::string upper_wall(const std::string& displacement, const std::string& axis) {
  return half_space("upper", "kind = \"moving_wall\"\ndisplacement = " + displacement, "[0, 0.35]",
                    "[0, -1]") +
         measurement("force",
                     "kind = \"wall_force\"\nboundary = \"upper\"\naxis = \"" + axis + "\"");
}

std::unique_ptr<Solver> solver_of(const std::string& text) {
  return methods().make(tests::read_text(text), {2, kernels::widest_supported()});
}

struct Allowed {
  std::string method;
  int across;
  double deviation;
};

// The force is 9.45 N/m with 60 particles across in the total Lagrangian method and 9.50 in the
// point-based one. If walls held everything within half a spacing, it would be 1.17, 1.07 and 1.11
// of that in the total Lagrangian method, and 1.06, 1.18 and 1.03 in the point-based one.
TEST(overhangs, shear_a_disc_between_its_caps_alike_at_any_spacing) {
  for (const Allowed& allowed : {Allowed{"total_lagrangian", 8, 0.045},
                                 {"total_lagrangian", 10, 0.035},
                                 {"total_lagrangian", 13, 0.02},
                                 {"total_lagrangian", 20, 0.007},
                                 {"point_based", 8, 0.07},
                                 {"point_based", 10, 0.065},
                                 {"point_based", 13, 0.045}}) {
    const auto run = solver_of(round_body(2, allowed.method, allowed.across, 3) +
                               upper_wall("[\"0.3*min(t/2, 1)\", 0]", "x"));
    const double force = mean_force(*run, "force", 2.5, 3);
    const double expected = allowed.method == "total_lagrangian" ? 9.45 : 9.50;
    EXPECT_NEAR(force, expected, allowed.deviation * expected) << allowed.method << allowed.across;
  }
}

// The top moves by 53.0 mm under a weight that acts sideways (total Lagrangian, 24 across), by 12
// to 27 % less if overhangs are held.
TEST(overhangs, let_a_ball_hang_from_its_cap_alike_at_any_spacing) {
  for (const Allowed& allowed : {Allowed{"total_lagrangian", 8, 0.065},
                                 {"total_lagrangian", 12, 0.02},
                                 {"point_based", 8, 0.13},
                                 {"point_based", 12, 0.085}}) {
    const auto run = solver_of(
        "gravity = [2, 0, 0]\n" + round_body(3, allowed.method, allowed.across, 5) +
        measurement("top", "kind = \"point_displacement\"\npoint = [0, 0, 0.5]\naxis = \"x\""));
    run->advance(5);
    EXPECT_NEAR(values(*run)["top"], 0.0530, allowed.deviation * 0.0530)
        << allowed.method << allowed.across;
  }
}

// The flanks come against the walls and rest there. What the walls take back in a step is not lost
// to damping: counted as that, it would be up to 0.97 of the work.
TEST(overhangs, rest_on_the_walls_that_press_the_body_without_a_loss_to_damping) {
  for (const auto& [method, across] : {std::pair<std::string, int>{"total_lagrangian", 13},
                                       {"point_based", 13},
                                       {"point_based", 20}}) {
    const auto run =
        solver_of(round_body(2, method, across, 4) + upper_wall("[0, \"-0.25*min(t/2, 1)\"]", "y"));
    run->advance(4);
    const double work = run->energy_budget()->wall_work;
    EXPECT_GT(work, 4) << method << across;
    EXPECT_NEAR(balance(*run), 0, 0.01 * work) << method << across;
  }
}

TEST(overhangs, are_warned_of_where_bodies_are_thin) {
  static constexpr ThinBodyError errors[] = {{10.5, "it overhangs"}};
  const auto warnings = [&](int dimension, int across, const std::string& wall) {
    std::string text = round_body(dimension, "total_lagrangian", across, 1);
    const std::string cap = "-0.35";
    text.replace(text.find(cap), cap.size(), wall);
    std::vector<std::string> found;
    warn_of_overhangs(tests::read_text(text), errors, found);
    return found.size();
  };
  for (const int dimension : {2, 3}) {
    EXPECT_EQ(warnings(dimension, 10, "-0.35"), 1) << dimension;
    EXPECT_EQ(warnings(dimension, 12, "-0.35"), 0) << dimension;
    EXPECT_EQ(warnings(dimension, 10, "0"), 0) << dimension << ": a right angle";
    EXPECT_EQ(warnings(dimension, 10, "0.2"), 0) << dimension << ": an acute angle";
  }
}

}  // namespace
}  // namespace pliant::test
