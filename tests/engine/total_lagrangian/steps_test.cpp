#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/total_lagrangian/volumetric_mode.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

// The length of steps does not depend on when a run is observed.
namespace pliant::test {
namespace {

/// A plate of rubber, 1 m long and 5 particles thick, that swings in its first bending mode.
std::string plate(const std::string& velocity, const std::string& more = {}) {
  return R"(
method = "total_lagrangian"
dimension = 2
discretisation = { spacing = 0.02 }
time = { end = 30, step = "cfl" }
[material.rubber]
model = "reduced_polynomial"
density = 1
coefficients = [19.23]
compressibility = 0.024
[[body]]
name = "plate"
material = "rubber"
geometry = { shape = "box", lower = [0, -0.05], upper = [1, 0.05] }
velocity = [0, ")" +
         velocity + "\"]\n" + more;
}

/// Free at both ends, with an amplitude of about 0.1 m.
std::string free_plate() {
  return plate(
      "0.35*(cos(4.73004*x) + cosh(4.73004*x) - 0.98250221*(sin(4.73004*x) + sinh(4.73004*x)))");
}

/// Clamped on the left, with an amplitude of about 0.17 m.
std::string clamped_plate() {
  return plate(
      "0.03*(3.0377857*(cosh(1.8751041*x) - cos(1.8751041*x)) - "
      "2.2300249*(sinh(1.8751041*x) - sin(1.8751041*x)))",
      R"([[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
)");
}

std::vector<double> state_of(const LagrangianSolver<2>& solver) {
  std::vector<double> values = {solver.clock().time};
  const auto& body = solver.state().bodies[0];
  for (int a = 0; a < 2; ++a) {
    for_each_particle<2>(body, [&](std::int64_t p, const Point<2>&) {
      values.push_back(body.displacement[a][p]);
      values.push_back(body.velocity[a][p]);
    });
  }
  return values;
}

TEST(total_lagrangian, output_times_do_not_alter_a_run) {
  const Case settings = tests::read_text(clamped_plate());
  LagrangianSolver<2> through(settings, {1, kernels::widest_supported()});
  through.advance(0.5);
  for (const int samples : {7, 900, 3000}) {
    LagrangianSolver<2> sampled(settings, {1, kernels::widest_supported()});
    for (int s = 1; s <= samples; ++s) sampled.advance(0.5 * s / samples);
    EXPECT_EQ(sampled.clock().step, through.clock().step) << samples;
    EXPECT_EQ(state_of(sampled), state_of(through)) << samples;
  }
}

TEST(total_lagrangian, between_steps_particles_are_on_their_straight_way) {
  const Case settings = tests::read_text(free_plate());
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  solver.advance(0.3);
  solver.step(HUGE_VAL);
  const std::vector<double> start = state_of(solver);
  const double step = solver.time_step();
  solver.step(0.25 * step);
  const std::vector<double> quarter = state_of(solver);
  solver.step(HUGE_VAL);
  const std::vector<double> end = state_of(solver);
  for (std::size_t i = 0; i < start.size(); i += 1) {
    const bool is_velocity = i > 0 && i % 2 == 0;
    EXPECT_NEAR(quarter[i], is_velocity ? end[i] : 0.75 * start[i] + 0.25 * end[i], 1e-14);
  }
}

/// Minimum and maximum energy relative to the start, in a run that is sampled every 3.2 ms.
std::pair<double, double> energy_range(const std::string& text, double end) {
  LagrangianSolver<2> solver(tests::read_text(text), {1, kernels::widest_supported()});
  const auto energy = [&] {
    const BodyIntegrals sum = solver.integrals();
    return sum.kinetic_energy + sum.strain_energy;
  };
  const double start = energy();
  std::pair<double, double> range = {1, 1};
  for (int sample = 1; 0.0032 * sample < end; ++sample) {
    solver.advance(0.0032 * sample);
    const double ratio = energy() / start;
    range = {std::min(range.first, ratio), std::max(range.second, ratio)};
  }
  return range;
}

// With steps cut short at the samples, the energy would grow by a factor of thousands.
TEST(total_lagrangian, undamped_plates_keep_their_energy_at_finite_amplitude) {
  for (const std::string& text : {free_plate(), clamped_plate()}) {
    const auto [least, largest] = energy_range(text, 15);
    EXPECT_GT(least, 0.995);
    EXPECT_LT(largest, 1.005);
  }
}

double breathing_of_box(int x, int y, int z) {
  const std::string upper =
      "upper = [" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + "]";
  LagrangianSolver<3> solver(
      tests::read_text(tests::with(free_block(3), "upper = [1, 1, 1]", upper),
                       {"discretisation.spacing=1"}),
      {1, kernels::widest_supported()});
  return total_lagrangian::volumetric_mode_factor(solver.state().bodies[0]);
}

// (TL.23), compared with eigenvalues of the dense matrix of the same cells. The worst places are
// the ends of a bar and the corners of a box.
TEST(total_lagrangian, cells_at_free_surfaces_breathe_faster_than_waves) {
  EXPECT_NEAR(breathing_of_box(1, 1, 1), 3, 1e-12);
  EXPECT_NEAR(breathing_of_box(1, 1, 12), 2.3333, 0.01 * 2.3333);
  EXPECT_NEAR(breathing_of_box(2, 2, 2), 1.5, 1e-12);
  EXPECT_NEAR(breathing_of_box(1, 8, 8), 1.7925, 0.01 * 1.7925);
  EXPECT_NEAR(breathing_of_box(6, 6, 6), 1.3797, 0.01 * 1.3797);
}

/// A nearly incompressible bar, one cell thick, that is clamped and swings.
std::string thin_bar(const std::string& poissons_ratio) {
  return R"(
method = "total_lagrangian"
dimension = 3
discretisation = { spacing = 0.1 }
time = { end = 30, step = "cfl" }
[[body]]
name = "bar"
geometry = { shape = "box", lower = [0, 0, 0], upper = [1, 0.1, 0.1] }
material = { model = "neo_hookean", density = 1, youngs_modulus = 100, poissons_ratio = )" +
         poissons_ratio + R"( }
velocity = [0, "0.3*x^2", "0.1*x"]
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }
)";
}

// Without (TL.23) cells of the second bar turn inside out within fifty steps.
TEST(total_lagrangian, thin_bars_are_stable_at_the_default_step_whatever_their_poissons_ratio) {
  for (const std::string ratio : {"0.3", "0.49", "0.499"}) {
    LagrangianSolver<3> solver(tests::read_text(thin_bar(ratio)), {1, kernels::widest_supported()});
    const auto energy = [&] {
      const BodyIntegrals sum = solver.integrals();
      return sum.kinetic_energy + sum.strain_energy;
    };
    const double start = energy();
    for (int k = 1; k <= 20; ++k) {
      solver.advance(0.25 * k);
      EXPECT_NEAR(energy(), start, 0.02 * start) << ratio << " " << k;
    }
  }
}

}  // namespace
}  // namespace pliant::test
