#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// (PB.6) and (PB.7) for particles that carry F: a block between two slip walls under a pressure.
namespace pliant::test {
namespace {

constexpr double pressure = 8;

const std::string pressed_block = R"toml(
[discretisation]
spacing = 0.05
damping = "adaptive"
[time]
end = 3
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
material = { model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "left"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[boundary]]
name = "floor"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "load"
kind = "pressure"
pressure = 8
geometry = { shape = "box", lower = [-1, 0.9999], upper = [2, 2] }
[[measurement]]
name = "right"
kind = "point_displacement"
point = [1, 0.5]
axis = "x"
[[measurement]]
name = "top"
kind = "point_displacement"
point = [0.5, 1]
axis = "y"
[[measurement]]
name = "energy"
kind = "strain_energy"
)toml";

/// Cauchy stresses [Pa] and psi [J/m^3] of E = 100 and nu = 0.3 in plane strain at principal
/// stretches.
struct StateOfStretch {
  double xx, yy, energy;
};

StateOfStretch neo_hookean(double x, double y) {
  const double mu = 100 / 2.6, lambda = 30 / (1.3 * 0.4), j = x * y;
  return {mu / j * (x * x - 1) + lambda * (j - 1), mu / j * (y * y - 1) + lambda * (j - 1),
          mu / 2 * (x * x + y * y - 2) - mu * std::log(j) + lambda / 2 * (j - 1) * (j - 1)};
}

StateOfStretch st_venant_kirchhoff(double x, double y) {
  const double mu = 100 / 2.6, lambda = 30 / (1.3 * 0.4);
  const double exx = (x * x - 1) / 2, eyy = (y * y - 1) / 2, trace = exx + eyy;
  return {x / y * (lambda * trace + 2 * mu * exx), y / x * (lambda * trace + 2 * mu * eyy),
          lambda / 2 * trace * trace + mu * (exx * exx + eyy * eyy)};
}

void expect_equilibrium(const std::string& model, StateOfStretch (*state_of)(double x, double y)) {
  const std::vector<double> found = values_at_end(tests::with(pressed_block, "neo_hookean", model));
  const StateOfStretch state = state_of(1 + found[0], 1 + found[1]);
  EXPECT_NEAR(state.xx, 0, 0.01 * pressure) << model;
  EXPECT_NEAR(state.yy, -pressure, 0.01 * pressure) << model;
  EXPECT_NEAR(found[2], state.energy, 0.02 * state.energy) << model;
}

TEST(hyperelastic_bodies, rest_at_the_stretch_whose_stress_bears_the_load) {
  expect_equilibrium("neo_hookean", neo_hookean);
  expect_equilibrium("st_venant_kirchhoff", st_venant_kirchhoff);
}

}  // namespace
}  // namespace pliant::test
