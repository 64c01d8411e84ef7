#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Loads that are formulas of the place bend a clamped beam: a moment of 10/12 N m/m on its end.
namespace pliant::test {
namespace {

std::map<std::string, double> bent_beam(const std::string& method, const std::string& load,
                                        int threads) {
  const std::string damping = method == "remeshed" ? "discretisation.damping" : method + ".damping";
  const Case settings = tests::read_text(fmt::format(
      R"toml(method = "{}"
discretisation.spacing = "1/12"
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
      method, damping, load));
  const auto run = methods().make(settings, {threads, kernels::widest_supported()});
  run->advance(3);
  return values(*run);
}

TEST(loads_of_place, bend_a_beam_by_their_moment) {
  // M L^2/(2 E' I) and M L/(E' I) times the height, E' = E/(1 - nu^2), I = 1/12. The clamp holds
  // the beam across, too, which stiffens it by 3 %.
  const double curvature = 10. / 12 / (1000 / 0.91 / 12);
  for (const std::string method : {"remeshed", "total_lagrangian", "point_based"}) {
    const auto pressed =
        bent_beam(method, "kind = \"pressure\"\npressure = \"-10*(y - 0.5)*min(t, 1)\"", 1);
    const auto pulled =
        bent_beam(method, "kind = \"traction\"\ntraction = [\"10*(y - 0.5)*min(t, 1)\", 0]", 2);
    for (const auto& found : {pressed, pulled}) {
      EXPECT_NEAR(found.at("tip"), -2 * curvature, 0.05 * 2 * curvature) << method;
      EXPECT_NEAR(found.at("upper"), 0.25 * 2 * curvature, 0.15 * 0.5 * curvature) << method;
    }
  }
}

TEST(loads_of_place, are_the_same_with_any_number_of_threads) {
  const std::string load = "kind = \"pressure\"\npressure = \"10*y^2*min(t, 1)\"";
  for (const std::string method : {"remeshed", "total_lagrangian", "point_based"}) {
    EXPECT_EQ(bent_beam(method, load, 1), bent_beam(method, load, 5)) << method;
  }
}

}  // namespace
}  // namespace pliant::test
