#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tests/engine/total_lagrangian/blocks.hpp"

// The total energy of undamped bodies that leapfrog conserves, (TL.30).
namespace pliant::test {
namespace {

const std::string total_energy =
    "[[measurement]]\nname = \"energy\"\nkind = \"total_energy\"\nbody = \"block\"\n"
    "relative = true\n";

/// Minimum and maximum of two energies relative to the start, sampled within steps and at their
/// ends: the measured total, and the sum of kinetic and strain energy.
struct Ranges {
  std::pair<double, double> measured = {1, 1}, sum = {1, 1};
};

template <int D>
Ranges ranges_of(const std::string& text, int steps, int samples_of_step) {
  LagrangianSolver<D> solver(tests::read_text(text + total_energy),
                             {1, kernels::widest_supported()});
  const auto sum = [&] {
    const BodyIntegrals all = solver.integrals();
    return all.kinetic_energy + all.strain_energy;
  };
  const auto widen = [](std::pair<double, double>& range, double value) {
    range = {std::min(range.first, value), std::max(range.second, value)};
  };
  const double start = sum(), measured = solver.measure()[0];
  Ranges found;
  for (int step = 0; step < steps; ++step) {
    const double length = solver.time_step();
    for (int s = 0; s < samples_of_step; ++s) {
      solver.step(s + 1 < samples_of_step ? length / samples_of_step : HUGE_VAL);
      widen(found.measured, solver.measure()[0] / measured);
      widen(found.sum, sum() / start);
    }
  }
  return found;
}

/// A free plate of 1 m, 5 particles thick, with an amplitude of 0.2 m.
std::string thick_plate() {
  return tests::with(tests::with(tests::with(free_block(2), "spacing = 0.125", "spacing = 0.04"),
                                 "upper = [1, 1]", "upper = [1, 0.2]"),
                     "end = 1,", "end = 10,") +
         "velocity = [0, \"0.97*(cos(4.73004*x) + cosh(4.73004*x) - 0.98250221*(sin(4.73004*x) + "
         "sinh(4.73004*x)))\"]\n";
}

TEST(total_lagrangian, thick_plates_keep_their_energy_throughout_at_the_default_step) {
  const Ranges found = ranges_of<2>(thick_plate(), 2000, 1);
  EXPECT_GT(found.measured.first, 0.995);
  EXPECT_LT(found.measured.second, 1.005);
  EXPECT_GT(found.sum.second, 1.01);  // sum of kinetic and strain energy at one time
}

}  // namespace
}  // namespace pliant::test
