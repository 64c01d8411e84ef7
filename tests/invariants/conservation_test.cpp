#include <gtest/gtest.h>

#include <numeric>

#include "engine/remeshed/observe/integrals.hpp"
#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {
namespace {

/// A periodic cell in strong motion, without remeshing unless a test requests it.
struct Conservation : testing::TestWithParam<const char*> {
  Solver solver(const Settings& more) const {
    const Settings lively = {"discretisation.spacing=1/24", "remeshing.every=1000",
                             "body.medium.velocity=[\"0.4 + 0.8*sin(2*pi*x)*sin(2*pi*y)\", "
                             "\"0.7*sin(2*pi*(x + y))\"]",
                             GetParam()};
    return {small_case("periodic_square", lively + more), {1, kernels::widest_supported()}};
  }
};
INSTANTIATE_TEST_SUITE_P(
    materials, Conservation,
    testing::Values(
        R"(body.medium.material={ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 })",
        R"(body.medium.material={ model = "reduced_polynomial", coefficients = [10], compressibility = 1, density = 1 })"),
    [](const auto& material) { return material.index == 0 ? "linear" : "hyperelastic"; });

struct Sums {
  double mass = 0, volume = 0, largest_volume_error = 0;
  Vector momentum = {};
};

Sums sums_of(const LatticeView& view) {
  Sums sums;
  const double cell = view.body.lattice.spacing * view.body.lattice.spacing;
  for_each(view.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    const double mass = view.fields.get(Field::mass)[p], v = view.fields.get(Field::volume)[p];
    sums.mass += mass;
    sums.volume += v;
    sums.largest_volume_error = std::max(sums.largest_volume_error, std::abs(v / cell - 1));
    for (int a = 0; a < 2; ++a) sums.momentum[a] += mass * view.fields.get(Field::velocity, a)[p];
  });
  return sums;
}

Sums particles_of(const Solver& solver) {
  const Body& body = solver.state().bodies[0];
  return sums_of({body, body.population, body.stage[0]});
}

// Sums of 576 equal terms: each addition has an error of up to 1.1e-16.
constexpr double rounding_of_sums = 6e-14;

TEST_P(Conservation, extensive_remeshing_keeps_mass_momentum_and_volume_to_rounding) {
  Solver solver = this->solver({});
  for (int remeshing = 0; remeshing < 5; ++remeshing) {
    advance(solver, 7);
    const Sums before = particles_of(solver), after = sums_of(solver.on_nodes()[0]);
    EXPECT_GT(before.largest_volume_error, 1e-3) << "nothing has been deformed";
    EXPECT_NEAR(after.mass, before.mass, rounding_of_sums);
    EXPECT_NEAR(after.volume, before.volume, rounding_of_sums);
    for (int a = 0; a < 2; ++a)
      EXPECT_NEAR(after.momentum[a], before.momentum[a], rounding_of_sums);
  }
}

TEST_P(Conservation, total_volume_stays_that_of_the_cell) {
  // Between remeshings the sum of v div u is the truncation error of div u, of second order in the
  // spacing.
  const auto volume_error = [&](const char* spacing) {
    Solver solver = this->solver(
        {std::string("discretisation.spacing=") + spacing, "remeshing.every=5", "time.step=1e-3"});
    advance(solver, 60);
    EXPECT_EQ(solver.clock().remeshings, 12);
    EXPECT_NEAR(particles_of(solver).mass, 1, rounding_of_sums);
    return std::abs(particles_of(solver).volume - 1);
  };
  const double coarse = volume_error("1/16"), fine = volume_error("1/32");
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, coarse / 3);
}

TEST_P(Conservation, resetting_remeshing_gives_every_particle_a_cell_and_keeps_the_density) {
  Solver reset = this->solver({"remeshing.volume=reset"}), extensive = this->solver({});
  advance(reset, 9);
  advance(extensive, 9);
  const LatticeView fresh = reset.on_nodes()[0], conserving = extensive.on_nodes()[0];
  const double cell = 1.0 / (24 * 24);
  double least = HUGE_VAL, most = 0;
  for_each(fresh.population, Kind::interior, [&](std::int64_t p, const Cell<2>&) {
    EXPECT_EQ(fresh.fields.get(Field::volume)[p], cell);
    const double density = fresh.fields.get(Field::mass)[p] / cell;
    EXPECT_NEAR(density,
                conserving.fields.get(Field::mass)[p] / conserving.fields.get(Field::volume)[p],
                1e-15);
    least = std::min(least, density);
    most = std::max(most, density);
  });
  EXPECT_GT(most - least, 1e-3) << "the density is the same everywhere";
}

}  // namespace
}  // namespace pliant::test
