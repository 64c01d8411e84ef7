#include <gtest/gtest.h>

#include <fmt/format.h>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Plates and bars clamped at one end, whose surface is compressed where it meets the clamp.
namespace pliant::test {
namespace {

struct Oscillation {
  std::vector<double> zeros,
      peaks;          ///< times of zeros of the tip's deflection, and largest deflections
  double energy = 0;  ///< at the end, relative to the start
};

/// Plate theory for the first mode, see the README of the case.
constexpr double right_period = 5.94;

Oscillation swing(double spacing, double amplitude, double end, double thickness = 0.1) {
  const Case settings = small_case(
      "oscillating_plate",
      {fmt::format("discretisation.spacing={}", spacing),
       fmt::format("body.plate.geometry={{shape=\"box\", lower=[0, {}], upper=[1, {}]}}",
                   -thickness / 2, thickness / 2),
       fmt::format(
           "body.plate.velocity=[0, \"{}*(3.0377857*(cosh(1.8751041*x) - cos(1.8751041*x)) - "
           "2.2300249*(sinh(1.8751041*x) - sin(1.8751041*x)))\"]",
           0.00751263 * amplitude)});
  std::size_t tip = 0, energy = 0;
  for (std::size_t m = 0; m < settings.measurements.size(); ++m) {
    if (settings.measurements[m].name == "tip_displacement") tip = m;
    if (settings.measurements[m].name == "total_energy") energy = m;
  }
  remeshed::Solver<double, 2> solver(settings, {2, kernels::widest_supported()});
  Oscillation found;
  const double start = solver.measure()[energy];
  double before = 0, largest = 0, time = 0;
  while (time + 0.05 < end) {
    advance_until(solver, time + 0.05);
    const std::vector<double> values = solver.measure();
    const double now = values[tip];
    largest = std::max(largest, std::abs(now));
    if (before * now < 0) {
      found.zeros.push_back(time + (solver.clock().time - time) * before / (before - now));
      found.peaks.push_back(largest);
      largest = 0;
    }
    before = now;
    time = solver.clock().time;
    found.energy = values[energy] / start;
  }
  return found;
}

// Four times the amplitude of the case, a sixth of the length, with five particles across: too few
// for a period within 3 %, and for a bound on the lost energy. A growing zigzag of the surface used
// to make the period 17 % longer.
TEST(plates, that_are_coarse_and_bend_far_stay_stable) {
  const Oscillation found = swing(0.02, 4, 6.5);
  ASSERT_GE(found.zeros.size(), 2u);
  EXPECT_NEAR(found.zeros[1], right_period, 0.03 * right_period);
  EXPECT_LT(found.energy, 1.005);
}

TEST(plates, with_ten_particles_across_keep_period_amplitude_and_energy) {
  const Oscillation found = swing(0.01, 1, 12.5);
  ASSERT_GE(found.zeros.size(), 4u);
  EXPECT_NEAR(found.zeros[3] / 2, right_period, 0.005 * right_period);
  EXPECT_GT(found.peaks[2] / found.peaks[0], 0.975);
  EXPECT_GT(found.energy, 0.9);
  EXPECT_LT(found.energy, 1.005);
}

// With the whole outgoing characteristic it would have 2.4 times its energy by then.
TEST(plates, that_are_thick_gain_no_energy) {
  constexpr double period = 3.05;  // Timoshenko's theory
  const Oscillation found = swing(0.02, 2.26, 3 * period, 0.2);
  ASSERT_GE(found.zeros.size(), 4u);
  EXPECT_NEAR(found.zeros[3] / 2, period, 0.01 * period);
  EXPECT_GT(found.energy, 0.9);
  EXPECT_LT(found.energy, 1.005);
}

// Tips swing by a fifth of the length. When such plates were remeshed only where they are strained
// or turned, waves across them grew where the surface crossed a row of nodes: these had 1.15
// and 1.05 of their energy.
TEST(plates, that_bend_far_gain_no_energy) {
  for (const double spacing : {0.0125, 0.01}) {
    const Oscillation found = swing(spacing, 4.65, 3 * right_period);
    ASSERT_GE(found.zeros.size(), 4u);
    EXPECT_NEAR(found.zeros[3] / 2, right_period, 0.01 * right_period);
    EXPECT_GT(found.energy, 0.9);
    EXPECT_LT(found.energy, 1.005);
  }
}

constexpr const char* free_plate = R"toml(
time = { end = 100 }
[[body]]
name = "plate"
geometry = { shape = "box", lower = [-5, -0.5], upper = [5, 0.5] }
material = { model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }
# The first mode of a free beam; its ends swing by 0.14.
velocity = [0, "0.1468*(cosh(0.473*(x + 5)) + cos(0.473*(x + 5)) - 0.9825*(sinh(0.473*(x + 5)) + sin(0.473*(x + 5))))"]
[discretisation]
)toml";

// They used to break in their second and fourth periods.
TEST(plates, that_nothing_holds_gain_no_energy) {
  constexpr double period = 2.94;
  for (const char* spacing : {"spacing = 0.1", "spacing = \"1/14\""}) {
    SCOPED_TRACE(spacing);
    const Case settings = tests::read_text(std::string(free_plate) + spacing);
    remeshed::Solver<double, 2> solver(settings, {2, kernels::widest_supported()});
    const double start = solver.integrals().kinetic_energy;
    advance_until(solver, 6 * period);
    const BodyIntegrals end = solver.integrals();
    const double kept = (end.kinetic_energy + end.strain_energy) / start;
    EXPECT_GT(kept, 0.85);
    EXPECT_LT(kept, 1.005);
  }
}

/// Largest deflection of a clamped plate under its weight g: bending with the plane strain modulus,
/// and shear (Timoshenko).
double hanging_tip(double thickness, double gravity) {
  const double modulus = 100 / (1 - 0.3 * 0.3), shear_modulus = 100 / 2.6, share = 5. / 6;
  return gravity * (12 / (8 * modulus * thickness * thickness) + 1 / (2 * share * shear_modulus));
}

/// Deflection of the tip relative to plate theory, and mass relative to the start, of a plate with
/// five particles across that hangs from its clamp.
struct Hanging {
  double tip, mass;
};

Hanging hang(const std::string& material, double end) {
  const double thickness = 0.2, gravity = 0.224;
  const Case settings = small_case(
      "oscillating_plate",
      {"discretisation.spacing=0.04", "discretisation.damping=1", "body.plate.velocity=[0, 0]",
       "body.plate.geometry={shape=\"box\", lower=[0, -0.1], upper=[1, 0.1]}",
       "body.plate.material=" + material,
       fmt::format("gravity=[0, \"-{}*min(t/3, 1)\"]", gravity)});
  remeshed::Solver<double, 2> solver(settings, {1, kernels::widest_supported()});
  const double mass = solver.integrals().mass;
  advance_until(solver, end);
  const std::vector<double> values = solver.measure();
  double tip = 0;
  for (std::size_t m = 0; m < values.size(); ++m) {
    if (settings.measurements[m].name == "tip_displacement") tip = values[m];
  }
  return {-tip / hanging_tip(thickness, gravity), solver.integrals().mass / mass};
}

// Three periods after loading, with the recommended minimum of five particles across. Particles
// that nothing pulls back to the lattice leave it in a zigzag that the gradient does not see: the
// tip used to sink by 15 % within 12 s, and the mass to grow by 0.8 %.
TEST(plates, that_hang_from_their_clamp_stay_where_they_are) {
  const Hanging plate =
      hang("{model=\"linear\", youngs_modulus=100, poissons_ratio=0.3, density=1}", 12);
  EXPECT_NEAR(plate.tip, 1, 0.05);
  EXPECT_NEAR(plate.mass, 1, 0.003);
}

// The same material as a law of F, without relaxation of shear stress. When ghosts of the free
// surface moved with the lasting part of (RP.50), they fed a checkerboard of stress: the plate
// became unstable within 3 s.
TEST(plates, of_materials_that_carry_f_hang_still) {
  const Hanging plate = hang(
      "{model=\"reduced_polynomial\", coefficients=[19.2308], compressibility=0.024, density=1}",
      12);
  EXPECT_NEAR(plate.tip, 1, 0.05);
  EXPECT_NEAR(plate.mass, 1, 0.003);
}

constexpr const char* bar_under_pressure = R"toml(
title = "a bar that a pressure holds bent"
dimension = 3
discretisation = { spacing = 0.04, damping = 1 }
time = { end = 8 }
[[body]]
name = "bar"
geometry = { shape = "box", lower = [0, -0.1, -0.1], upper = [1, 0.1, 0.1] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "clamp"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [1, 0, 0] }
[[boundary]]
name = "load"
kind = "pressure"
geometry = { shape = "box", lower = [-0.5, 0.099, -1], upper = [1.5, 1, 1] }
pressure = "0.0448*min(t/3, 1)"
[[measurement]]
name = "tip"
kind = "point_displacement"
point = [1, 0, 0]
axis = "y"
)toml";

/// Limit of trilinear elements of 0.04 and 0.02 m (total_lagrangian: 0.0852 and 0.0860 m); beam
/// theory for small displacements gives 0.0874 m.
constexpr double right_tip_of_bar = 0.0863;

// With the recommended minimum of five particles across. With all of (RP.50) and relaxation of the
// shear stress, the tip was 12 % too low by now and the bar broke at 13 s.
TEST(bars, that_a_pressure_holds_bent_stay_where_they_are) {
  const Case settings = tests::read_text(bar_under_pressure);
  remeshed::Solver<double, 3> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, 8);
  EXPECT_NEAR(-solver.measure().at(0), right_tip_of_bar, 0.05 * right_tip_of_bar);
}

}  // namespace
}  // namespace pliant::test
