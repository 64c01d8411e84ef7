#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/case/method_rules.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Contact in which next to nothing moves, for thousands of steps.
namespace pliant::test {
namespace {

/// The mean force over half a second from `time` on. What a solver measures of a force is its
/// impulse.
double mean_after(Solver& solver, double time) {
  advance_until(solver, time);
  const double before = solver.measure()[0];
  advance_until(solver, time + 0.5);
  return (solver.measure()[0] - before) / 0.5;
}

Case squeezed_block(const std::string& material) {
  return tests::read_text(R"toml(
[discretisation]
spacing = 0.025
damping = 5
[time]
end = 4
[[body]]
name = "block"
geometry = { shape = "box", lower = [-0.1, 0], upper = [0.1, 0.2] }
material = { )toml" + material +
                          R"toml(, density = 1 }
[[boundary]]
name = "floor"
kind = "contact_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "press"
kind = "contact_wall"
displacement = [0, "-0.01*min(t/3, 1)"]
geometry = { shape = "half_space", point = [0, 0.2], normal = [0, -1] }
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "floor"
axis = "y"
)toml");
}

// Hooke's law of the logarithmic strain, on a block that widens. The walls moved for 750 steps;
// with a remeshing after every ten of them the block kept 0.76 of this force.
TEST(slow_contact, a_block_that_walls_squeeze_slowly_keeps_its_stress) {
  const double nu = 0.3, strain = std::log(0.2 / 0.19);
  const double width = 0.2 * std::exp(nu / (1 - nu) * strain);
  const double force = 100 / (1 - nu * nu) * strain * width;
  for (const char* material :
       {R"(model = "linear", youngs_modulus = 100, poissons_ratio = 0.3)",
        R"(model = "reduced_polynomial", coefficients = ["25/1.3"], compressibility = 0.024)"}) {
    Solver solver(squeezed_block(material), {1, kernels::widest_supported()});
    EXPECT_NEAR(mean_after(solver, 3.5), force, 0.02 * force) << material;
  }
}

Case stack() {
  return tests::read_text(R"toml(
gravity = [0, -10]
[discretisation]
spacing = 0.02
damping = 5
[time]
end = 4
[[body]]
name = "lower"
geometry = { shape = "box", lower = [-0.2, 0], upper = [0.2, 0.2] }
material = "rubber"
[[body]]
name = "upper"
geometry = { shape = "box", lower = [-0.06, 0.2], upper = [0.06, 0.32] }
material = "rubber"
[material.rubber]
model = "linear"
youngs_modulus = 100
poissons_ratio = 0.3
density = 1
[[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[contact]]
bodies = ["upper", "lower"]
kind = "coulomb"
friction = 0.3
[[measurement]]
name = "push"
kind = "contact_force"
bodies = ["upper", "lower"]
axis = "y"
)toml");
}

// With a remeshing after every ten steps the blocks swung ever more, and the run was stopped within
// a second.
TEST(slow_contact, a_block_at_rest_on_a_block_presses_with_its_weight) {
  Solver solver(stack(), {1, kernels::widest_supported()});
  const double weight = 10 * 0.12 * 0.12;
  EXPECT_NEAR(mean_after(solver, 2.5), weight, 0.02 * weight);
  EXPECT_LT(solver.integrals().kinetic_energy, 1e-4 * weight * 0.12);
}

TEST(slow_contact, of_bodies_under_loads_is_warned_of) {
  const auto warned = warnings_of_method(stack());
  ASSERT_FALSE(warned.empty());
  EXPECT_NE(warned.back().find("if bodies rest on each other"), std::string::npos);
  EXPECT_TRUE(warnings_of_method(small_case("two_discs", {})).empty());
}

}  // namespace
}  // namespace pliant::test
