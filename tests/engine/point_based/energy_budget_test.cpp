#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/undeformed/loads.hpp"

// The energy budget of the point-based method closes.
namespace pliant::test {
namespace {

// A block that vibrates freely: its energy hardly varies more within steps than between them.
TEST(point_energy_budget, kinetic_and_strain_energy_within_a_step_belong_together) {
  const Case settings = tests::read_text(free_points(2) + "velocity = [\"0.2*(x - 0.5)\", 0]\n",
                                         {"discretisation.spacing=0.05"});
  const auto spread = [&settings](double steps) {
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    const double step = solver.time_step();
    double least = HUGE_VAL, most = 0;
    for (int sample = 1; sample * steps < 60; ++sample) {
      solver.advance(sample * steps * step);
      const auto now = solver.integrals();
      const double energy = now.kinetic_energy + now.strain_energy;
      least = std::min(least, energy);
      most = std::max(most, energy);
    }
    return most - least;
  };
  EXPECT_LT(spread(0.3), 1.1 * spread(1));
}

// The loads start suddenly: steps are short for the resulting waves, whose energy is of second
// order in the leapfrog method.
TEST(point_energy_budget, work_of_walls_loads_and_gravity_is_in_the_bar_or_was_damped) {
  const std::string text =
      "gravity = [\"sin(2*t)\", -3]\n" + free_points(2) +
      half_space("floor",
                 "kind = \"moving_wall\"\nvelocity = [\"t < 0.4 ? 1 - cos(15.7079633*t) : 0\", 0]",
                 "[0, 0]", "[0, 1]") +
      R"toml([[boundary]]
name = "pull"
kind = "traction"
geometry = { shape = "box", lower = [-9, 0.999], upper = [9, 9] }
traction = ["5*sin(3*t)", 4]
[[boundary]]
name = "push"
kind = "pressure"
geometry = { shape = "box", lower = [0.999, 0.3], upper = [9, 9] }
pressure = 3
)toml";
  for (const char* damping : {"0", "3"}) {
    const Case settings =
        tests::read_text(text, {std::string("point_based.damping=") + damping, "time.step=1e-3"});
    PointSolver<2> solver(settings, {1, kernels::widest_supported()});
    advance_until(solver, 0.8);
    const EnergyBudget budget = *solver.energy_budget();
    EXPECT_GT(std::abs(budget.load_work), 0.05);
    EXPECT_GT(budget.wall_work, 0.1);
    EXPECT_NEAR(balance(solver), 0, 0.01 * budget.wall_work);
    if (damping[0] != '0') {
      EXPECT_GT(budget.damping, 0.01 * budget.wall_work);
    }
  }
}

// The budget includes changes of the strain energy by changed bonds and by relaxing gradients, so
// that it closes during a cut.
TEST(point_energy_budget, closes_through_a_cut) {
  const std::string text =
      free_points(2) + half_space("left", "kind = \"fixed\"", "[0, 0]", "[1, 0]") +
      half_space("right", "kind = \"moving_wall\"\nvelocity = [\"t < 0.2 ? 0.5 : 0\", 0]", "[1, 0]",
                 "[-1, 0]") +
      R"toml([[cut]]
name = "blade"
from = [0.53, 1.1]
path = [0, "-2*(t - 0.4)"]
start = 0.4
end = 0.8
)toml";
  const Case settings = tests::read_text(text, {"discretisation.spacing=0.0625"});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  advance_until(solver, 1);
  const EnergyBudget budget = *solver.energy_budget();
  EXPECT_NE(budget.cut_work, 0);
  EXPECT_NEAR(balance(solver), 0, 0.02 * budget.wall_work);
}

}  // namespace
}  // namespace pliant::test
