#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// Adaptive damping, (TL.10), (PB.65), of a cantilever that bends under its slowly growing weight.
namespace pliant::test {
namespace {

double deflection(const std::string& method, const std::string& precision) {
  const std::string text = fmt::format(R"toml(method = "{0}"
precision = "{1}"
gravity = [0, "-1.5*min(t/2, 1)"]
discretisation.spacing = "1/24"
time.end = 4
{0}.damping = "adaptive"
[[body]]
name = "beam"
geometry = {{ shape = "box", lower = [0, 0], upper = [4, 1] }}
material = {{ model = "neo_hookean", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = {{ shape = "half_space", point = [0, 0], normal = [1, 0] }}
)toml",
                                       method, precision) +
                           measurement("tip",
                                       "kind = \"point_displacement\"\naxis = \"y\"\n"
                                       "point = [3.98, 0.52]");
  const auto run = methods().make(tests::read_text(text), {});
  run->advance(4);
  return values(*run)["tip"];
}

// From one step to the next, rounding to single precision changes the forces more than the slow
// motion does.
TEST(damping_in_single_precision, is_that_of_the_motion) {
  for (const std::string method : {"total_lagrangian", "point_based"}) {
    const double exact = deflection(method, "double");
    EXPECT_NEAR(exact, -0.5317, 0.0005) << method;
    EXPECT_NEAR(deflection(method, "single"), exact, 2e-4) << method;
  }
}

}  // namespace
}  // namespace pliant::test
