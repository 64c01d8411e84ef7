#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/whole_runs.hpp"

// The forces of blades on the tissue, (PB.18).
namespace pliant::test {
namespace {

/// A blade with these keys that cuts the block from below along `path`, from t = 0.05 to 0.55.
std::string pushing_blade(int dimension, const std::string& path, const std::string& keys) {
  const std::string edge = dimension == 2
                               ? "from = [0.45, -0.125]\n"
                               : "from = [0.45, -0.125, -0.125]\nto = [0.45, -0.125, 1.125]\n";
  return "[[cut]]\nname = \"blade\"\n" + edge + "path = " + path + "\nstart = 0.05\nend = 0.55\n" +
         keys;
}

const std::string blade_measurements = R"([[measurement]]
name = "force"
kind = "blade_force"
cut = "blade"
axis = "y"
[[measurement]]
name = "work"
kind = "cutting_work"
cut = "blade"
)";

template <int D>
PointSolver<D> bladed_solver(const std::string& text) {
  return PointSolver<D>(tests::read_text(text), {1, kernels::widest_supported()});
}

// Whether the edge is in the body, and how far it has cut, changes in steps of an eighth of a
// spacing.
TEST(blade_forces, take_the_energy_of_the_new_faces) {
  for (const std::string path : {"[0, \"2.5*(t - 0.05)\", 0]", "[0, \"5*(t - 0.05)^2\", 0]"}) {
    auto solver = bladed_solver<3>(free_points(3) + pushing_blade(3, path, "resistance = 0.1\n") +
                                   blade_measurements);
    advance_until(solver, 0.6);
    EXPECT_NEAR(solver.measure(1), 0.1, 0.1 * 0.03) << path;
  }
}

TEST(blade_forces, close_the_budgets_of_momentum_and_energy) {
  auto solver =
      bladed_solver<3>(free_points(3) + "velocity = [\"0.3*y\", 0, \"0.2*x\"]\n" +
                       pushing_blade(3, R"toml(["0.2*(t - 0.05)", "2.5*(t - 0.05)", 0])toml",
                                     "resistance = 2\nfriction = 1\ndrag = 0.2\n"));
  const BodyIntegrals start = solver.integrals();
  advance_until(solver, 0.7);
  const BodyIntegrals end = solver.integrals();
  const auto& impulse = solver.state().blades[0].impulse;
  EXPECT_GT(impulse[1], 0.5);
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(end.momentum[a] - start.momentum[a], impulse[a], 1e-12);
  }
  const EnergyBudget budget = *solver.energy_budget();
  const double gained =
      end.kinetic_energy + end.strain_energy - start.kinetic_energy - start.strain_energy;
  EXPECT_GT(budget.blade_work, 0.5);
  // The error of the leapfrog method.
  EXPECT_NEAR(gained, budget.work(), 2e-3 * budget.blade_work);
}

TEST(blade_forces, fall_where_the_blade_saws) {
  // F = 1 in a body that hardly moves: with the ratio s of slicing to pushing, the resistance to
  // pushing is G_c/(1 + s^2), and along the edge s times that.
  for (const double s : {0., 1., 2.}) {
    const std::string along = "\"" + std::to_string(s) + "*(t - 0.05)\"";
    auto solver =
        bladed_solver<3>(free_points(3) + pushing_blade(3, "[0, \"t - 0.05\", " + along + "]",
                                                        "resistance = 1e-4\n"));
    advance_until(solver, 0.3);
    const auto force = solver.blade_force(0);
    const double length = 1 - std::max(0., 0.25 * s - 0.125);  // of the edge inside the body
    EXPECT_NEAR(force[1], 1e-4 * length / (1 + s * s), 0.07e-4) << s;
    EXPECT_NEAR(force[2], 1e-4 * length * s / (1 + s * s), 0.07e-4) << s;
  }
}

// Only friction remains.
TEST(blade_forces, take_no_energy_for_what_is_cut_already) {
  const std::string there_and_back = R"toml([0, "0.6 - abs(2.4*(t - 0.05) - 0.6)"])toml";
  auto solver =
      bladed_solver<2>(free_points(2) + pushing_blade(2, there_and_back, "resistance = 0.01\n") +
                       blade_measurements);
  advance_until(solver, 0.29);
  EXPECT_GT(solver.blade_force(0)[1], 0);
  advance_until(solver, 0.3);
  const double cut = solver.measure(1);
  EXPECT_NEAR(cut, 0.01 * (0.6 - 0.125), 0.01 * 0.02);
  advance_until(solver, 0.5);
  EXPECT_NEAR(solver.measure(1), cut, 0.01 * 0.02);
  EXPECT_EQ(solver.blade_force(0)[1], 0);
}

TEST(blade_forces, of_friction_and_drag_resist_in_both_directions) {
  const std::string there_and_back = R"toml([0, "0.6 - abs(2.4*(t - 0.05) - 0.6)"])toml";
  auto solver = bladed_solver<2>(
      free_points(2) + pushing_blade(2, there_and_back, "friction = 1e-4\ndrag = 1e-3\n"));
  advance_until(solver, 0.25);
  const double speed = 2.4, expected = 1e-4 + 1e-3 * speed;
  EXPECT_NEAR(solver.blade_force(0)[1], expected, 0.01 * expected);
  advance_until(solver, 0.4);
  EXPECT_NEAR(solver.blade_force(0)[1], -expected, 0.01 * expected);
  advance_until(solver, 0.6);
  EXPECT_EQ(solver.blade_force(0)[1], 0);
}

TEST(blade_forces, of_blades_that_callers_put_take_the_same_energy) {
  auto solver = bladed_solver<2>(
      free_points(2) + pushing_blade(2, "[0, 0]", "resistance = 0.01\n") + blade_measurements);
  for (int step = 0; solver.clock().time < 0.5; ++step) {
    solver.put_blade(0, {0.45, -0.2 + 4 * solver.clock().time, 0}, {});
    solver.step(HUGE_VAL);
  }
  EXPECT_NEAR(solver.measure(1), 0.01, 0.01 * 0.05);
}

TEST(blade_forces, are_the_same_bytes_over_threads_and_after_a_restart) {
  const TemporaryFolder folder;
  const Case settings = tests::read_text(
      free_points(3) +
          pushing_blade(3, R"toml([0, "2.5*(t - 0.05)", "sin(20*(t - 0.05))"])toml",
                        "resistance = 2\nfriction = 1\ndrag = 0.2\n") +
          blade_measurements,
      {"time.end=0.4", "output.every=0.15"});
  const FileContent one = result_of(settings, folder / "one", 1);
  EXPECT_EQ(result_of(settings, folder / "two", 2), one);
  EXPECT_EQ(result_of(settings, folder / "one", 2, true), one);
}

TEST(blade_forces, need_a_cut_that_exists) {
  EXPECT_NE(tests::complaint(free_points(2) + pushing_blade(2, "[0, \"t\"]", "resistance = 1\n") +
                             "[[measurement]]\nname = \"f\"\nkind = \"blade_force\"\n"
                             "cut = \"blad\"\n")
                .find("names the cut \"blad\", which does not exist; did you mean `blade`?"),
            std::string::npos);
  EXPECT_NE(tests::complaint(free_points(2) + pushing_blade(2, "[0, \"t\"]", "resistance = -1\n"))
                .find("resistance must be 0 or more"),
            std::string::npos);
}

}  // namespace
}  // namespace pliant::test
