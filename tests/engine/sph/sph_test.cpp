#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation/methods.hpp"
#include "engine/sph/solver.hpp"
#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/remeshed/small_case.hpp"

// Plain SPH, the baseline of the paper.
namespace pliant::test {
namespace {

const Settings gently = {"sph.artificial_stress=0.3"};
const Settings coarse = {"discretisation.spacing=0.1", "time.step=1e-3"};

Case disc(const Settings& more = {}) { return small_case("tensile_instability", more); }

double measured(const Case& settings, const std::string& name, double time) {
  std::size_t m = 0;
  while (settings.measurements.at(m).name != name) ++m;
  const auto solver = methods().make(settings, {.threads = 2});
  solver->advance(time);
  return solver->measure()[m];
}

void take_steps(pliant::Solver& solver, int count) {
  for (int i = 0; i < count; ++i) solver.step(HUGE_VAL);
}

struct Sph : testing::Test {
  /// Everything that a checkpoint of a solver holds.
  FileContent state_of(const pliant::Solver& solver) const {
    ArchiveWriter writer(folder / "state.h5");
    solver.save(writer);
    writer.commit();
    return content_of(folder / "state.h5");
  }
  TemporaryFolder folder;
};

// The disc stretches by only some percent.
TEST_F(Sph, clumps_in_tension_unless_an_artificial_stress_keeps_particles_apart) {
  EXPECT_LT(measured(disc(coarse), "closest_pair", 0.5), 0.6);
  EXPECT_GT(measured(disc(coarse + gently), "closest_pair", 0.5), 0.75);
}

TEST_F(Sph, is_what_clumps_and_not_the_particles_of_the_moment_matrix) {
  const Settings other =
      coarse + Settings{"method=remeshed", "sph={}", "discretisation.dissipation=0.1"};
  for (const char* every : {"never", "7"}) {
    const Settings remeshing = {std::string("remeshing.every=") + every};
    EXPECT_GT(measured(disc(other + remeshing), "closest_pair", 0.5), 0.95) << every;
  }
}

// Pair forces are opposite; those of the stress do not act along the line between two particles.
TEST_F(Sph, keeps_momentum_to_rounding) {
  const Settings thrown = {"discretisation.spacing=0.1",
                           "body.disc.rotation={ centre = [0.5, 0.2], angular_velocity = \"pi\" }"};
  sph::Solver<double, 2> solver(disc(gently + thrown), {.threads = 2});
  const BodyIntegrals start = solver.integrals();
  take_steps(solver, 40);
  const BodyIntegrals end = solver.integrals();
  EXPECT_NEAR(end.momentum[0], start.momentum[0], 1e-13 * start.mass);
  EXPECT_NEAR(end.momentum[1], start.momentum[1], 1e-13 * start.mass);
  EXPECT_NE(end.kinetic_energy, start.kinetic_energy);
}

TEST_F(Sph, has_the_same_bits_for_any_number_of_threads_and_from_a_checkpoint) {
  const Case settings = disc(gently);
  sph::Solver<double, 2> one(settings, {.threads = 1});
  take_steps(one, 10);
  ArchiveWriter writer(folder / "solver.h5");
  one.save(writer);
  writer.commit();
  take_steps(one, 15);
  sph::Solver<double, 2> many(settings, {.threads = 7});
  take_steps(many, 25);
  EXPECT_EQ(differences(state_of(one), state_of(many)), std::vector<std::string>());
  sph::Solver<double, 2> restored(settings, {.threads = 2});
  restored.restore(ArchiveReader(folder / "solver.h5"));
  take_steps(restored, 15);
  EXPECT_EQ(differences(state_of(one), state_of(restored)), std::vector<std::string>());
}

TEST_F(Sph, looking_ahead_changes_nothing) {
  sph::Solver<double, 2> solver(disc(coarse), {.threads = 1});
  sph::Solver<double, 2> watched(disc(coarse), {.threads = 1});
  for (int i = 0; i < 10; ++i) {
    watched.look_ahead(watched.clock().time + 4e-4, [&] { watched.measure(); });
    solver.step(HUGE_VAL);
    watched.step(HUGE_VAL);
  }
  EXPECT_EQ(differences(state_of(solver), state_of(watched)), std::vector<std::string>());
}

TEST_F(Sph, any_legal_order_of_a_step_gives_the_same_bits) {
  const auto state_after = [&](std::uint64_t seed) {
    sph::Solver<double, 2> solver(disc(gently), {.threads = 1});
    solver.step(HUGE_VAL);
    solver.step_graph().run_serially(seed);
    return state_of(solver);
  };
  const FileContent first = state_after(1);
  EXPECT_EQ(differences(first, state_after(2)), std::vector<std::string>());
}

// A stress of principal values 6 and -2 Pa on axes turned by 30 degrees, at a density of 2.
TEST_F(Sph, has_artificial_stress_along_axes_in_tension_only) {
  sph::Solver<double, 2> solver(disc(), {.threads = 1});
  Body& body = solver.state().bodies[0];
  const double c = std::sqrt(3) / 2, s = 0.5;
  const double stress[3] = {6 * c * c - 2 * s * s, 8 * c * s, 6 * s * s - 2 * c * c};
  const double expected[3] = {-0.3 * 6 / 4 * c * c, -0.3 * 6 / 4 * c * s, -0.3 * 6 / 4 * s * s};
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    for (int k = 0; k < 3; ++k) body.stress[k][p] = stress[k];
    body.stage[0].get(Field::mass)[p] = 2 * body.stage[0].get(Field::volume)[p];
  });
  sph::PairStress<double, 2> pairs;
  pairs.grow(body.population.layout.slots());
  for (std::size_t b = 0; b < body.population.layout.blocks().size(); ++b) {
    sph::find_pair_stress<double, 2>(body, static_cast<int>(b), 0, 0.3, pairs);
  }
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(pairs.scaled[k][p], stress[k] / 4, 1e-14);
      ASSERT_NEAR(pairs.artificial[k][p], expected[k], 1e-14);
    }
  });
}

}  // namespace
}  // namespace pliant::test
