#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

// A cylinder that a body force twists by 0.85 rad. Its energy went through 1.26 and 0.78 times the
// last value, as its surface seemed to push it on, (RP.61).
TEST(adaptive_damping_of_the_remeshed_method, brings_a_body_to_rest_that_turns_far) {
  const Case settings = tests::read_text(R"toml(dimension = 3
gravity = ["-8*y", "8*x", 0]
discretisation = { spacing = 0.125, damping = "adaptive" }
time = { end = 3 }
[[body]]
name = "cylinder"
material = { model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
geometry.shape = "intersection"
geometry.of = [
  { shape = "box", lower = [-1, -1, 0], upper = [1, 1, 3] },
  { shape = "cylinder", centre = [0, 0, 0], axis = [0, 0, 1], radius = 0.5 },
]
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [0, 0, 1] }
[[measurement]]
name = "energy"
kind = "strain_energy"
)toml");
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  double largest = 0, energy = 0;
  for (int i = 1; i <= 15; ++i) {
    advance_until(solver, 0.2 * i);
    energy = solver.measure()[0];
    largest = std::max(largest, energy);
  }
  EXPECT_LT(largest, 1.005 * energy);
  EXPECT_NEAR(energy, 0.756, 0.01 * 0.756);
}

// A cantilever that its weight bends by 0.4 of its length. It went on swinging, with an energy of
// 1.5 times that at rest. The reference is the total Lagrangian method with 32 cells across.
TEST(adaptive_damping_of_the_remeshed_method, brings_a_beam_to_rest_that_bends_far) {
  const std::vector<double> found = values_at_end(R"toml(dimension = 2
gravity = [0, -0.5]
discretisation = { spacing = 0.1, damping = "adaptive" }
time = { end = 12 }
[[body]]
name = "beam"
material = { model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
geometry = { shape = "box", lower = [0, 0], upper = [4, 1] }
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[measurement]]
name = "tip"
kind = "point_displacement"
point = [4, 0.5]
axis = "y"
[[measurement]]
name = "energy"
kind = "strain_energy"
)toml");
  EXPECT_NEAR(found[0], -1.650, 0.03 * 1.650);
  EXPECT_NEAR(found[1], 0.6633, 0.03 * 0.6633);
}

}  // namespace
}  // namespace pliant::test
