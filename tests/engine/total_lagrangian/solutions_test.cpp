#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/simulation/oscillation.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

// Tests against solutions in closed form.
namespace pliant::test {
namespace {

// A bar between frictionless walls vibrates along its length: u = A cos(pi x) cos(pi c t).
double error_of_standing_wave(double spacing, const std::string& cfl) {
  const std::string walls = R"([[boundary]]
name = "below"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "above"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0.25], normal = [0, -1] }
)";
  const Case settings =
      tests::read_text(tests::with(free_block(2), "[1, 1]", "[1, 0.25]") +
                           "velocity = [\"1e-4*cos(pi*x)\", 0]\n" + walls,
                       {"discretisation.spacing=" + std::to_string(spacing), "time.cfl=" + cfl});
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  const double frequency = std::numbers::pi * std::sqrt(2 / 0.05 + 4. / 3 * 20);
  const double time = 2.2 * std::numbers::pi / frequency;
  advance_until(solver, time);
  double error = 0;
  const auto& body = solver.state().bodies[0];
  for_each_particle<2>(body, [&](std::int64_t p, const Point<2>& x) {
    const double exact =
        1e-4 / frequency * std::cos(std::numbers::pi * x[0]) * std::sin(frequency * time);
    error = std::max(error, std::abs(body.displacement[0][p] - exact));
  });
  return error * frequency / 1e-4;
}

TEST(total_lagrangian, a_standing_wave_converges_to_second_order) {
  const double coarse = error_of_standing_wave(0.0625, "0.5");
  const double fine = error_of_standing_wave(0.03125, "0.5");
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
  // Near the stability limit the errors in time and space nearly cancel.
  EXPECT_LT(error_of_standing_wave(0.03125, "0.9"), fine / 5);
}

/// Cauchy stress along x and y of a block stretched by l1, l2 in plane strain, (RP.9).
std::pair<double, double> stress_of_stretch(double l1, double l2) {
  const double j = l1 * l2, scale = std::pow(j, -2. / 3);
  const double b1 = scale * l1 * l1, b2 = scale * l2 * l2, mean = (b1 + b2 + scale) / 3;
  const double volumetric = 2 / 0.05 * (j - 1);
  return {20 / j * (b1 - mean) + volumetric, 20 / j * (b2 - mean) + volumetric};
}

// Two walls hold two sides of the block without friction; suction pulls on a third. The pull
// changes with the face as that contracts: true stress, not force per original area.
TEST(total_lagrangian, a_block_relaxes_to_the_stretch_at_which_it_bears_the_suction) {
  const Case settings = tests::read_text(free_block(2) + R"([[boundary]]
name = "left"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [1, 0] }
[[boundary]]
name = "below"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "suction"
kind = "pressure"
geometry = { shape = "box", lower = [0.999, -9], upper = [9, 9] }
pressure = -20
)",
                                         {"time.end=20", "total_lagrangian.damping=adaptive"});
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 20);
  double l1 = 1, l2 = 1;
  for (int i = 0; i < 200; ++i) {  // Newton's method with finite differences
    const auto [a, b] = stress_of_stretch(l1, l2);
    const auto [a1, b1] = stress_of_stretch(l1 + 1e-7, l2);
    const auto [a2, b2] = stress_of_stretch(l1, l2 + 1e-7);
    const double p = (a1 - a) / 1e-7, q = (a2 - a) / 1e-7, r = (b1 - b) / 1e-7, s = (b2 - b) / 1e-7;
    const double f = a - 20, g = b, det = p * s - q * r;
    l1 -= (s * f - q * g) / det;
    l2 -= (p * g - r * f) / det;
  }
  EXPECT_GT(l1, 1.2);
  const auto& body = solver.state().bodies[0];
  for_each_particle<2>(body, [&](std::int64_t p, const Point<2>& x) {
    EXPECT_NEAR(body.displacement[0][p], (l1 - 1) * x[0], 1e-6);
    EXPECT_NEAR(body.displacement[1][p], (l2 - 1) * x[1], 1e-6);
  });
  EXPECT_LT(solver.integrals().kinetic_energy, 1e-10);
}

TEST(total_lagrangian, scaled_mass_rings_slower_by_the_root_of_the_scaling) {
  const std::vector<std::string> scaled = {"total_lagrangian.mass_scaling=16"};
  const std::string text = free_block(2) + "velocity = [\"1e-3*x\", \"-1e-3*y\"]\n";
  LagrangianSolver<2> solver(tests::read_text(text), {1, kernels::widest_supported()});
  LagrangianSolver<2> slow(tests::read_text(text, scaled), {1, kernels::widest_supported()});
  EXPECT_NEAR(slow.time_step() / solver.time_step(), 4, 1e-12);
  EXPECT_NEAR(slow.integrals().mass, 1, 1e-12);
  advance_until(solver, 0.05);
  advance_until(slow, 0.2);
  const auto& fast_body = solver.state().bodies[0];
  const auto& slow_body = slow.state().bodies[0];
  for_each_particle<2>(fast_body, [&](std::int64_t p, const Point<2>&) {
    // The same path four times slower, so displacements are four times larger.
    EXPECT_NEAR(slow_body.displacement[0][p], 4 * fast_body.displacement[0][p], 1e-7);
  });
}

/// Period of a clamped plate, ten times as long as thick, two cells thick.
double period_of_coarse_plate(const std::vector<std::string>& more) {
  std::vector<std::string> changes = {
      "method=total_lagrangian", "discretisation.spacing=0.05",
      "body.plate.material={model=\"reduced_polynomial\",density=1,coefficients=[19.230769],"
      "compressibility=0.024}"};
  changes.insert(changes.end(), more.begin(), more.end());
  const Case settings = read_case(PLIANT_SOURCE_DIR "/cases/oscillating_plate", changes);
  LagrangianSolver<2> solver(settings, {1, kernels::widest_supported()});
  std::vector<double> times, tips;
  while (solver.clock().time < 13 * (1 - 1e-12)) {
    solver.advance(solver.clock().time + 0.05);
    times.push_back(solver.clock().time);
    tips.push_back(solver.measure()[0]);
  }
  return oscillation_period(times, tips);
}

// (TL.17) in plane strain.
TEST(total_lagrangian,
     two_cells_across_bend_as_a_plate_with_the_hourglass_stiffness_of_the_material) {
  EXPECT_NEAR(period_of_coarse_plate({}) / 5.94, 1, 0.002);
  const double of_shear = period_of_coarse_plate({"total_lagrangian.hourglass_stiffness=1"});
  EXPECT_GT(std::abs(of_shear / 5.94 - 1), 0.03);
}

}  // namespace
}  // namespace pliant::test
