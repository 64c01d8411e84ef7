#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Loads that are formulas of the place bend a clamped beam: a moment of 10/12 N m/m on its end.
namespace pliant::test {
namespace {

std::map<std::string, double> bent_beam(const std::string& method, const std::string& spacing,
                                        const std::string& load, int threads) {
  const std::string damping = method == "remeshed" ? "discretisation.damping" : method + ".damping";
  const Case settings = tests::read_text(fmt::format(
      R"toml(method = "{}"
discretisation.spacing = "{}"
{} = "adaptive"
time.end = 3
[[body]]
name = "beam"
geometry = {{ shape = "box", lower = [0, 0], upper = [2, 1] }}
material = {{ model = "neo_hookean", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = {{ shape = "half_space", point = [0, 0], normal = [1, 0] }}
[[boundary]]
name = "load"
{}
geometry = {{ shape = "box", lower = [1.9999, -1], upper = [3, 2] }}
[[measurement]]
name = "tip"
kind = "point_displacement"
point = [2, 0.5]
axis = "y"
[[measurement]]
name = "upper"
kind = "point_displacement"
point = [2, 0.75]
axis = "x"
)toml",
      method, spacing, damping, load));
  const auto run = methods().make(settings, {threads, kernels::widest_supported()});
  run->advance(3);
  return values(*run);
}

TEST(loads_of_place, bend_a_beam_by_their_moment) {
  // M L^2/(2 E' I) and M L/(E' I) times the height, E' = E/(1 - nu^2), I = 1/12. The clamp holds
  // the beam across, too, which stiffens it by 3 %.
  const double curvature = 10. / 12 / (1000 / 0.91 / 12);
  constexpr double held = 0.97;
  for (const std::string method : {"remeshed", "total_lagrangian", "point_based"}) {
    for (const std::string spacing : {"1/8", "1/12"}) {
      const auto pressed = bent_beam(
          method, spacing, "kind = \"pressure\"\npressure = \"-10*(y - 0.5)*min(t, 1)\"", 1);
      const auto pulled = bent_beam(
          method, spacing, "kind = \"traction\"\ntraction = [\"10*(y - 0.5)*min(t, 1)\", 0]", 2);
      for (const auto& found : {pressed, pulled}) {
        EXPECT_NEAR(found.at("tip"), -held * 2 * curvature, 0.025 * 2 * curvature)
            << method << spacing;
        EXPECT_NEAR(found.at("upper"), 0.25 * 2 * curvature, 0.15 * 0.5 * curvature)
            << method << spacing;
      }
    }
  }
}

// A free body gains the angular momentum of the torque, whatever its stiffness. Loads that are
// linear along a face act exactly, (PB.67): at nodes they would turn this body by 1.125 times the
// torque, at the middles of facets by 0.94. The total Lagrangian method measures momentum with a
// mass matrix that is consistent, not lumped.
TEST(loads_of_place, turn_a_coarse_body_by_their_torque) {
  constexpr double end = 0.01;
  for (const auto& [method, tolerance] :
       {std::pair<std::string, double>{"total_lagrangian", 0.05}, {"point_based", 1e-4}}) {
    const auto plane =
        methods().make(tests::read_text(tests::rubber_case(method, 2, "0.25", "0.01") + R"toml(
[[body]]
name = "square"
material = "rubber"
geometry = { shape = "box", lower = [-0.5, -0.5], upper = [0.5, 0.5] }
[[boundary]]
name = "turn"
kind = "traction"
traction = ["x", "-6*y"]
geometry = { shape = "half_space", point = [0.4999, 0], normal = [-1, 0] }
[[boundary]]
name = "push"
kind = "pressure"
pressure = "12*x"
geometry = { shape = "half_space", point = [0, 0.4999], normal = [0, -1] }
[[measurement]]
name = "momentum"
kind = "angular_momentum"
)toml"),
                       {});
    plane->advance(end);
    EXPECT_NEAR(values(*plane)["momentum"] / end, -1, tolerance) << method;
    const auto bar =
        methods().make(tests::read_text(tests::rubber_case(method, 3, "0.25", "0.01") + R"toml(
[[body]]
name = "bar"
material = "rubber"
geometry = { shape = "box", lower = [-0.5, -0.5, 0], upper = [0.5, 0.5, 1] }
[[boundary]]
name = "turn"
kind = "traction"
traction = ["-6*y", "6*x", "0"]
geometry = { shape = "half_space", point = [0, 0, 0.9999], normal = [0, 0, -1] }
[[measurement]]
name = "momentum"
kind = "angular_momentum"
axis = "z"
)toml"),
                       {});
    bar->advance(end);
    EXPECT_NEAR(values(*bar)["momentum"] / end, 1, tolerance) << method;
  }
}

// The corners of facets lie between nodes there, and other nodes bear the pressure with them.
TEST(loads_of_place, lift_a_disc_by_the_weight_of_the_water_it_displaces) {
  constexpr double end = 0.005, pi = 3.14159265358979;
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const auto disc =
        methods().make(tests::read_text(tests::rubber_case(method, 2, "0.125", "0.005") + R"toml(
[[body]]
name = "disc"
material = "rubber"
geometry = { shape = "disc", centre = [0.3, 2], radius = 0.5 }
[[boundary]]
name = "water"
kind = "pressure"
pressure = "4*(3 - y)"
geometry = { shape = "box", lower = [-9, -9], upper = [9, 9] }
[[measurement]]
name = "momentum"
kind = "momentum"
axis = "y"
)toml"),
                       {});
    disc->advance(end);
    EXPECT_NEAR(values(*disc)["momentum"] / end, pi, 0.01 * pi) << method;
  }
}

TEST(loads_of_place, are_the_same_with_any_number_of_threads) {
  const std::string load = "kind = \"pressure\"\npressure = \"10*y^2*min(t, 1)\"";
  for (const std::string method : {"remeshed", "total_lagrangian", "point_based"}) {
    EXPECT_EQ(bent_beam(method, "1/12", load, 1), bent_beam(method, "1/12", load, 5)) << method;
  }
}

}  // namespace
}  // namespace pliant::test
