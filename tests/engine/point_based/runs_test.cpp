#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/methods.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/whole_runs.hpp"

namespace pliant::test {
namespace {

TEST(point_based, a_tumbling_block_keeps_momenta_to_rounding_and_its_energy) {
  PointSolver<3> solver(tests::read_text(free_points(3) + tumbling),
                        {2, kernels::widest_supported()});
  const BodyIntegrals start = solver.integrals();
  EXPECT_NEAR(start.mass, 1, 1e-12);
  advance_until(solver, 1);
  const BodyIntegrals end = solver.integrals();
  const double momentum = 5;  // a bound on the integral of rho abs(u)
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(end.momentum[axis], start.momentum[axis], 1e-14 * momentum);
    EXPECT_NEAR(end.angular_momentum[axis], start.angular_momentum[axis], 1e-13 * momentum);
  }
  EXPECT_GT(end.strain_energy, 1e-3);
  const double energy = start.kinetic_energy + start.strain_energy;
  EXPECT_NEAR(end.kinetic_energy + end.strain_energy, energy, 5e-3 * energy);
}

TEST(point_based, linear_materials_are_neo_hookean) {
  const auto energies = [](const std::string& model) {
    PointSolver<3> solver(
        tests::read_text(tests::with(free_points(3), "neo_hookean", model) + tumbling),
        {1, kernels::widest_supported()});
    advance_until(solver, 0.2);
    const BodyIntegrals sum = solver.integrals();
    return std::pair{sum.kinetic_energy, sum.strain_energy};
  };
  EXPECT_EQ(energies("linear"), energies("neo_hookean"));
}

// A bar between frictionless walls vibrates along its length: u = A cos(pi x) cos(pi c t).
double error_of_standing_wave(const std::string& spacing) {
  const std::string walls = R"([[boundary]]
name = "below"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[boundary]]
name = "above"
kind = "slip_wall"
geometry = { shape = "half_space", point = [0, 0.25], normal = [0, -1] }
)";
  const Case settings = tests::read_text(tests::with(free_points(2), "[1, 1]", "[1, 0.25]") +
                                             "velocity = [\"1e-4*cos(pi*x)\", 0]\n" + walls,
                                         {"discretisation.spacing=" + spacing});
  PointSolver<2> solver(settings, {1, kernels::widest_supported()});
  const double frequency = std::numbers::pi * std::sqrt(100 * 0.3 / (1.3 * 0.4) + 2 * 100 / 2.6);
  const double time = 2.2 * std::numbers::pi / frequency;
  advance_until(solver, time);
  double error = 0;
  const auto& body = solver.state().bodies[0];
  body.for_each_node([&](std::int64_t slot) {
    const double exact = 1e-4 / frequency * std::cos(std::numbers::pi * body.start[slot][0]) *
                         std::sin(frequency * time);
    error = std::max(error, std::abs(body.displacement[0][slot] - exact));
  });
  return error * frequency / 1e-4;
}

// The tip of a beam of 10 x 2 x 1 m with flattened cells, as the spacing divides only its length
// and width: bonds across the whole thickness of 0.4 and 2/3 made it 8 and 28 % too soft. With 6
// and 8 total Lagrangian hexahedra across, it sags by 9.94 mm.
TEST(point_based, flattened_cells_bend_as_cubes_do) {
  for (const auto& [spacing, bar] :
       {std::pair{"0.4", 0.025}, std::pair{"1/3", 0.01}, std::pair{"2/3", 0.06}}) {
    const std::vector<std::string> settings = {
        std::string("discretisation.spacing=") + spacing, "point_based.damping=0.2",
        "body.beam.geometry={ shape = \"box\", lower = [0, -1, -0.5], upper = [10, 1, 0.5] }"};
    PointSolver<3> solver(read_case(PLIANT_SOURCE_DIR "/cases/cantilever", settings),
                          {1, kernels::widest_supported()});
    advance_until(solver, 200);
    EXPECT_NEAR(solver.measure()[0], -9.94e-3, bar * 9.94e-3) << spacing;
  }
}

TEST(point_based, a_standing_wave_converges) {
  const double coarse = error_of_standing_wave("0.0625"), fine = error_of_standing_wave("0.03125");
  EXPECT_LT(fine, 0.03);
  EXPECT_GT(std::log2(coarse / fine), 1);
}

Case driven(const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings = {"time.end=0.2", "output.every=0.0501",
                                       "point_based.stiffness_damping=1e-4",
                                       "discretisation.spacing=0.1"};
  settings.insert(settings.end(), more.begin(), more.end());
  return tests::read_text(free_points(3) + tumbling + clamp, settings);
}

TEST(point_based, bytes_do_not_depend_on_the_number_of_threads) {
  const TemporaryFolder folder;
  const FileContent one = result_of(driven(), folder / "1", 1);
  for (const int threads : {2, 7}) {
    EXPECT_EQ(result_of(driven(), folder / std::to_string(threads), threads), one) << threads;
  }
}

TEST(point_based, bytes_do_not_depend_on_a_restart) {
  const TemporaryFolder folder;
  for (const std::string setting :
       {"precision=double", "precision=single", "point_based.damping=adaptive"}) {
    const Case settings = driven({setting});
    const FileContent through = result_of(settings, folder / setting, 1);
    // The last checkpoint is before the end: the continued run writes the end once more.
    EXPECT_EQ(result_of(settings, folder / setting, 2, true), through) << setting;
  }
}

TEST(point_based, output_times_do_not_alter_a_run) {
  PointSolver<3> through(driven(), {1, kernels::widest_supported()});
  PointSolver<3> watched(driven(), {1, kernels::widest_supported()});
  while (through.clock().step < 40) through.step(HUGE_VAL);
  int stops = 0;
  while (watched.clock().step < 40 || watched.clock().rest() > 0) {
    watched.step(stops++ % 3 == 0 ? 0.3 * watched.time_step() : HUGE_VAL);
  }
  EXPECT_GT(stops, 50);
  for (int a = 0; a < 3; ++a) {
    for (std::int64_t s = 0; s < through.state().bodies[0].slots; ++s) {
      ASSERT_EQ(watched.state().bodies[0].displacement[a][s],
                through.state().bodies[0].displacement[a][s]);
    }
  }
}

}  // namespace
}  // namespace pliant::test
