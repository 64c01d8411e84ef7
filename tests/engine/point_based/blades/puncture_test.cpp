#include "engine/point_based/blades/puncture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/method/step_failure.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/whole_runs.hpp"

// Blades that dent a body before they enter it, (PB.34) and (PB.35).
namespace pliant::test {
namespace {

constexpr double threshold = 3;  // [N], [N/m] in 2D

const std::string held_above = R"toml([[boundary]]
name = "ceiling"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 1, 0], normal = [0, -1, 0] }
)toml";

/// A blade that comes from below at this speed, from t = 0.05 to 0.55.
std::string denting_blade(int dimension, const std::string& speed, double force) {
  const std::string edge = dimension == 2
                               ? "from = [0.45, -0.01]\n"
                               : "from = [0.45, -0.01, -0.125]\nto = [0.45, -0.01, 1.125]\n";
  return "[[cut]]\nname = \"blade\"\n" + edge + "path = [0, \"" + speed + "*(t - 0.05)\"" +
         (dimension == 2 ? "]" : ", 0]") +
         "\nstart = 0.05\nend = 0.55\npuncture_force = " + std::to_string(force) + "\n";
}

const std::string cutting_measurement = R"([[measurement]]
name = "work"
kind = "cutting_work"
cut = "blade"
)";

std::string held_block(int dimension, double force) {
  std::string ceiling = held_above;
  if (dimension == 2) {
    ceiling.replace(ceiling.find("[0, 1, 0]"), 9, "[0, 1]");
    ceiling.replace(ceiling.find("[0, -1, 0]"), 10, "[0, -1]");
  }
  return free_points(dimension) + "[point_based]\ndamping = 20\n" + ceiling +
         denting_blade(dimension, "0.5", force) + cutting_measurement;
}

template <int D>
PointSolver<D> denting_solver(const std::string& text) {
  return PointSolver<D>(tests::read_text(text), {1, kernels::widest_supported()});
}

/// The mean force of a blade over each interval of 0.02 s, and the time of the first cut.
struct ForceHistory {
  std::vector<double> mean;
  double entered = HUGE_VAL;
};

template <int D>
ForceHistory force_history(PointSolver<D>& solver, double end) {
  constexpr double window = 0.02;
  ForceHistory history;
  while (solver.clock().time < end) {
    const double begin = solver.clock().time, before = solver.state().blades[0].impulse[1];
    while (solver.clock().time < begin + window) {
      solver.step(HUGE_VAL);
      if (!solver.state().cut_surfaces(0).empty()) {
        history.entered = std::min(history.entered, solver.clock().time);
      }
    }
    history.mean.push_back((solver.state().blades[0].impulse[1] - before) /
                           (solver.clock().time - begin));
  }
  return history;
}

template <int D>
void expect_puncture() {
  auto solver = denting_solver<D>(held_block(D, threshold));
  const ForceHistory history = force_history(solver, 0.5);
  ASSERT_LT(history.entered, 0.5);
  const auto top = std::max_element(history.mean.begin(), history.mean.end());
  // The force in single steps scatters about its mean; the last window includes part of the drop.
  EXPECT_NEAR(*top, threshold, 0.15 * threshold);
  for (auto at = history.mean.begin(); at + 2 < top; ++at) EXPECT_LE(*at, *(at + 2)) << D;
  EXPECT_EQ(history.mean.back(), 0);
  // The edge was 0.5 (t - 0.05) - 0.01 behind the place of the undeformed surface.
  const double dent = 0.5 * (history.entered - 0.05) - 0.01;
  EXPECT_GT(dent, 0.02);
  EXPECT_GT(solver.measure(0), 0.5 * threshold * dent);  // for a force that grows at most linearly
  EXPECT_LT(solver.measure(0), *top * dent);
}

TEST(puncture, takes_the_force_of_its_threshold) {
  expect_puncture<2>();
  expect_puncture<3>();
}

TEST(puncture, of_a_stronger_surface_comes_later) {
  double last = 0;
  for (const double force : {1.5, 2., 2.5, 3.}) {
    auto solver = denting_solver<2>(held_block(2, force));
    const double entered = force_history(solver, 0.5).entered;
    EXPECT_GT(entered, last) << force;
    last = entered;
  }
}

TEST(puncture, at_no_force_is_where_the_blade_is_at_the_surface) {
  auto solver = denting_solver<2>(held_block(2, 0));
  EXPECT_LT(force_history(solver, 0.2).entered, 0.1);
  EXPECT_EQ(solver.measure(0), 0);
}

TEST(puncture, closes_the_budgets_of_momentum_and_energy) {
  auto solver = denting_solver<3>(free_points(3) + denting_blade(3, "0.5", 1e9));
  const BodyIntegrals start = solver.integrals();
  advance_until(solver, 0.5);
  const BodyIntegrals end = solver.integrals();
  const auto& impulse = solver.state().blades[0].impulse;
  EXPECT_GT(impulse[1], 0.4);  // the body flies off at least at the speed of the blade
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(end.momentum[a] - start.momentum[a], impulse[a], 1e-12);
  }
  const EnergyBudget budget = *solver.energy_budget();
  const double gained = end.kinetic_energy + end.strain_energy;
  EXPECT_GT(budget.blade_work, 0.1);
  EXPECT_NEAR(gained, budget.work(),
              0.05 * budget.blade_work);  // impacts of single nodes consume some
}

TEST(puncture, continues_after_a_restart_to_the_same_bytes_on_any_number_of_threads) {
  const TemporaryFolder folder;
  std::string text = held_block(3, threshold);
  text.replace(text.find("time = { end = 1,"), 17, "time = { end = 0.5,");
  for (const double every : {0.12, 0.3}) {  // in the dent, and in the cut
    const Case settings =
        tests::read_text(text, {"output.every=" + std::to_string(every), "output.surface=true"});
    const FileContent through = result_of(settings, folder / "run", 1);
    EXPECT_EQ(result_of(settings, folder / "run", 2, true), through);
    EXPECT_EQ(result_of(settings, folder / "other", 2), through);
    std::filesystem::remove_all(folder / "run");
    std::filesystem::remove_all(folder / "other");
  }
}

TEST(puncture, of_a_surface_that_gives_way_first_names_the_cut_whose_force_is_too_large) {
  std::string text = held_block(3, 1e9);
  text.replace(text.find("0.5*(t"), 6, "1.8*(t");  // through 90 % of the block
  auto solver = denting_solver<3>(text);
  try {
    while (solver.clock().time < 0.55) solver.step(HUGE_VAL);
    FAIL();
  } catch (const StepFailure& failure) {
    const std::string message = failure.what();
    EXPECT_NE(message.find("let the blade of cut `blade` enter earlier (a smaller puncture_force)"),
              std::string::npos)
        << message;
  }
}

TEST(puncture, refuses_forces_that_are_negative) {
  const std::string message = tests::complaint(held_block(2, -1));
  EXPECT_NE(message.find("puncture_force must be"), std::string::npos) << message;
}

}  // namespace
}  // namespace pliant::test
