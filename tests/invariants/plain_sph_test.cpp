#include <gtest/gtest.h>

#include "engine/remeshed/pair_stress.hpp"
#include "engine/remeshed/solver.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/remeshed/snapshot.hpp"

// Plain SPH, the baseline of the paper.
namespace pliant::test {
namespace {

const Settings gently = {"discretisation.artificial_stress=0.3"};

Case disc(const Settings& more = {}) { return small_case("tensile_instability", more); }

double measured(const Case& settings, const std::string& name, double time) {
  std::size_t m = 0;
  while (settings.measurements.at(m).name != name) ++m;
  Solver solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, time);
  return solver.measure()[m];
}

const Settings coarse = {"discretisation.spacing=0.1", "time.step=1e-3"};

// The disc stretches by no more than some percent.
TEST(plain_sph, clumps_in_tension_unless_an_artificial_stress_keeps_particles_apart) {
  EXPECT_LT(measured(disc(coarse), "closest_pair", 0.5), 0.6);
  EXPECT_GT(measured(disc(coarse + gently), "closest_pair", 0.5), 0.75);
}

TEST(plain_sph, is_what_clumps_and_not_the_particles_of_the_moment_matrix) {
  const Settings other = coarse + Settings{"discretisation.operators=moment_matrix"};
  EXPECT_GT(measured(disc(other), "closest_pair", 0.5), 0.95);
  EXPECT_GT(measured(disc(other + Settings{"remeshing.every=7"}), "closest_pair", 0.5), 0.95);
}

// Pair forces are opposite; those of the stress are not along the line between two particles.
TEST(plain_sph, keeps_momentum_to_rounding) {
  const Settings thrown = {"discretisation.spacing=0.1",
                           "body.disc.rotation={ centre = [0.5, 0.2], angular_velocity = \"pi\" }"};
  Solver solver(disc(gently + thrown), {2, kernels::widest_supported()});
  const BodyIntegrals start = solver.integrals();
  advance(solver, 40);
  const BodyIntegrals end = solver.integrals();
  EXPECT_NEAR(end.momentum[0], start.momentum[0], 1e-13 * start.mass);
  EXPECT_NEAR(end.momentum[1], start.momentum[1], 1e-13 * start.mass);
  EXPECT_NE(end.kinetic_energy, start.kinetic_energy);
}

TEST(plain_sph, has_the_same_bits_for_any_number_of_threads_and_from_a_checkpoint) {
  const TemporaryFolder folder;
  const Case settings = disc(gently);
  Solver one(settings, {1, kernels::widest_supported()});
  advance(one, 10);
  ArchiveWriter writer(folder / "solver.h5");
  one.save(writer);
  writer.commit();
  advance(one, 15);
  Solver many(settings, {7, kernels::widest_supported()});
  advance(many, 25);
  EXPECT_EQ(differences(snapshot_of(one), snapshot_of(many)), std::vector<std::string>());
  Solver restored(settings, {2, kernels::widest_supported()});
  restored.restore(ArchiveReader(folder / "solver.h5"));
  advance(restored, 15);
  EXPECT_EQ(differences(snapshot_of(one), snapshot_of(restored)), std::vector<std::string>());
}

// A stress of principal values 6 and -2 Pa on axes turned by 30 degrees, at a density of 2.
TEST(plain_sph, has_artificial_stress_along_axes_in_tension_only) {
  Solver solver(disc(), {1, kernels::widest_supported()});
  Body& body = solver.state().bodies[0];
  const double c = std::sqrt(3) / 2, s = 0.5;
  const double stress[3] = {6 * c * c - 2 * s * s, 8 * c * s, 6 * s * s - 2 * c * c};
  const double expected[3] = {-0.3 * 6 / 4 * c * c, -0.3 * 6 / 4 * c * s, -0.3 * 6 / 4 * s * s};
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    for (int k = 0; k < 3; ++k) body.stress[k][p] = stress[k];
    body.stage[0].get(Field::mass)[p] = 2 * body.stage[0].get(Field::volume)[p];
  });
  for (std::size_t b = 0; b < body.population.layout.blocks().size(); ++b) {
    remeshed::find_pair_stress<double, 2>(body, static_cast<int>(b), 0, 0.3);
  }
  for_each(body.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(body.pair_stress[0][k][p], stress[k] / 4, 1e-14);
      ASSERT_NEAR(body.pair_stress[1][k][p], expected[k], 1e-14);
    }
  });
}

}  // namespace
}  // namespace pliant::test
