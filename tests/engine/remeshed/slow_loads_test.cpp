#include <gtest/gtest.h>

#include "tests/engine/case/written_case.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Blocks on a slip wall that loads slowly push or pull: their stress must be uniform, whatever the
// loads are near their edges.
namespace pliant::test {
namespace {

constexpr double load = 2, width = 0.2;

const std::string plane_block = R"toml(dimension = 2
[discretisation]
spacing = 0.02
damping = 50
[time]
end = 10
[[body]]
name = "block"
geometry = { shape = "box", lower = [-0.1, 0], upper = [0.1, 0.2] }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }
[[boundary]]
name = "floor"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[measurement]]
name = "reaction"
kind = "wall_force"
boundary = "floor"
axis = "y"
[[measurement]]
name = "along"
kind = "mean_value"
field = "stress_yy"
where = "(y > 0.06)*(y < 0.14)"
[[measurement]]
name = "across"
kind = "mean_value"
field = "stress_xx"
where = "(y > 0.06)*(y < 0.14)"
)toml";

const std::string pressure = R"toml([[boundary]]
name = "load"
kind = "pressure"
pressure = "2*min(t/0.2, 1)"
)toml";

const std::string pull = R"toml([[boundary]]
name = "load"
kind = "traction"
traction = [0, "2*min(t/0.2, 1)"]
)toml";

// The top alone: on a strip of the sides, the load would press the block across too.
const std::string top = "geometry = { shape = \"box\", lower = [-9, 0.1999999], upper = [9, 9] }\n";

/// The load that a block carries at rest relative to the exact one, and energy balance over work.
struct Found {
  double reaction, along, across, balance;
};

template <int D>
Found held(const std::string& text, const Settings& settings = {}) {
  const Case block = tests::read_text(text, settings);
  remeshed::Solver<double, D> solver(block, {1, kernels::widest_supported()});
  advance_until(solver, 0.4);
  const double before = solver.measure()[0], start = solver.clock().time;
  advance_until(solver, 0.45);
  const std::vector<double> now = solver.measure();
  const BodyIntegrals sum = solver.integrals();
  const EnergyBudget budget = *solver.energy_budget();
  const double created = sum.kinetic_energy + sum.strain_energy - budget.work() + budget.damping;
  return {(now[0] - before) / (solver.clock().time - start) / (load * std::pow(width, D - 1)),
          now[1] / load, now[2] / load, created / budget.work()};
}

void expect_uniform(const Found& found, double sign, double of_stress, double of_work) {
  EXPECT_NEAR(found.reaction, sign, 0.015);
  EXPECT_NEAR(found.along, -sign, of_stress);
  EXPECT_NEAR(found.across, 0, of_stress);
  EXPECT_NEAR(found.balance, 0, of_work);
}

TEST(slow_loads, a_pressed_block_has_the_stress_of_the_pressure) {
  expect_uniform(held<2>(plane_block + pressure + top), 1, 0.01, 0.01);
}

TEST(slow_loads, five_particles_across_are_enough) {
  expect_uniform(held<2>(plane_block + pressure + top, {"discretisation.spacing=0.04"}), 1, 0.01,
                 0.03);
}

TEST(slow_loads, a_block_between_the_nodes_has_it_too) {
  expect_uniform(held<2>(plane_block + pressure + top, {"discretisation.spacing=0.03"}), 1, 0.01,
                 0.05);
}

TEST(slow_loads, a_pulled_block_has_the_stress_of_the_traction) {
  expect_uniform(held<2>(plane_block + pull + top), -1, 0.01, 0.01);
}

}  // namespace
}  // namespace pliant::test
