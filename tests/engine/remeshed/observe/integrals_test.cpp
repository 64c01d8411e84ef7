#include "engine/remeshed/observe/integrals.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/engine/remeshed/spinning_disc.hpp"

namespace pliant::test {
namespace {

constexpr double omega = 3;
const Vector reference_point = {0.013, -0.021, 0};

BodyIntegrals integrals_at(double spacing) {
  Solver solver(spinning_disc(spacing), {1, kernels::Isa::sse2});
  return remeshed::integrate<double, 2>(solver.on_nodes()[0], solver.state().boundaries,
                                        reference_point);
}

/// Relative errors, as root mean squares over shifted lattices; r^4 pi/2 is the second moment of a
/// disc.
struct Errors {
  double mass = 0, angular_momentum = 0, kinetic_energy = 0;

  explicit Errors(double spacing) {
    const std::array<double, 6> factors = {0.93, 0.97, 1, 1.027, 1.04, 1.066};
    for (const double factor : factors) {
      const BodyIntegrals sum = integrals_at(factor * spacing);
      mass += std::pow(sum.mass / pi - 1, 2);
      angular_momentum += std::pow(sum.angular_momentum[2] / (omega * pi / 2) - 1, 2);
      kinetic_energy += std::pow(sum.kinetic_energy / (omega * omega * pi / 4) - 1, 2);
    }
    for (double* error : {&mass, &angular_momentum, &kinetic_energy}) {
      *error = std::sqrt(*error / factors.size());
    }
  }
};

// A surface cuts about 10/h sub-cells of area (h/10)^2 at random: (h/10)^1.5 in all.
TEST(integrals, of_a_disc_converge_with_the_power_three_halves_of_a_tenth_of_the_spacing) {
  const Errors coarse(0.1), fine(0.025);
  EXPECT_LT(fine.mass, coarse.mass / 6.5);  // 4^1.5 is 8; chance plays a part
  EXPECT_LT(fine.angular_momentum, coarse.angular_momentum / 6.5);
  EXPECT_LT(fine.kinetic_energy, coarse.kinetic_energy / 6.5);
  const double sampling = std::pow(0.01, 1.5);
  EXPECT_LT(coarse.mass, 0.2 * sampling);
  EXPECT_LT(coarse.angular_momentum, 0.2 * sampling);
  EXPECT_LT(coarse.kinetic_energy, 0.2 * sampling);
}

TEST(integrals, are_the_same_bits_for_any_number_of_threads) {
  Solver solver(spinning_disc(0.02), {1, kernels::Isa::sse2});
  const auto view = solver.on_nodes()[0];
  ASSERT_GT(view.population.layout.blocks().size(), 3U);
  const auto& walls = solver.state().boundaries;
  const BodyIntegrals in_turn = remeshed::integrate<double, 2>(view, walls, reference_point);
  for (const int threads : {1, 2, 7}) {
    scheduler::Workers workers(threads);
    const BodyIntegrals sum = remeshed::integrate<double, 2>(view, walls, reference_point, workers);
    EXPECT_EQ(sum.volume, in_turn.volume);
    EXPECT_EQ(sum.mass, in_turn.mass);
    EXPECT_EQ(sum.momentum, in_turn.momentum);
    EXPECT_EQ(sum.angular_momentum, in_turn.angular_momentum);
    EXPECT_EQ(sum.kinetic_energy, in_turn.kinetic_energy);
    EXPECT_EQ(sum.strain_energy, in_turn.strain_energy);
  }
}

TEST(integrals, a_body_that_spins_about_its_centre_has_no_momentum) {
  const BodyIntegrals sum = integrals_at(0.1);
  // As large as the errors of mass, as the nodes are not symmetric about the centre.
  EXPECT_NEAR(sum.momentum[0], 0, 1e-3);
  EXPECT_NEAR(sum.momentum[1], 0, 1e-3);
}

TEST(integrals, of_uniform_fields_are_area_times_value) {
  Solver solver(spinning_disc(0.05), {1, kernels::Isa::sse2});
  Body& body = solver.state().bodies[0];
  const double s[] = {2, 1, -0.5};  // xx, xy, yy
  for (int c = 0; c < 3; ++c) {
    std::fill_n(body.stage[0].get(Field::material, c), body.population.layout.slots(), s[c]);
  }
  const BodyIntegrals sum = remeshed::integrate<double, 2>(
      solver.on_nodes()[0], solver.state().boundaries, reference_point);
  const double mu = 100 / 2.6, zz = -(s[0] + s[2]);
  const double density = (s[0] * s[0] + 2 * s[1] * s[1] + s[2] * s[2] + zz * zz) / (4 * mu);
  EXPECT_NEAR(sum.strain_energy, sum.mass * density, 1e-12);
}

TEST(integrals, count_only_what_lies_in_front_of_walls) {
  Solver solver(small_case("compression_linear", {"discretisation.spacing=1/16"}),
                {1, kernels::Isa::sse2});
  const BodyIntegrals sum =
      remeshed::integrate<double, 2>(solver.on_nodes()[0], solver.state().boundaries, {});
  // Surfaces half-way between nodes are captured exactly.
  EXPECT_NEAR(sum.mass, 2, 1e-12);
  // u = -25 y. Cells at a surface, less than half of all, are sampled at the centres of sub-cells.
  const double sampling = 0.5 * 25 * 25 * std::pow(1 / 160.0, 2) / 12;
  EXPECT_NEAR(sum.kinetic_energy, 0.5 * 25 * 25 * 2.0 / 3, sampling);
  EXPECT_NEAR(sum.momentum[1], 0, 1e-12);
}

TEST(integrals, sums_over_particles_are_those_of_their_masses) {
  const Solver solver(spinning_disc(0.1), {1, kernels::Isa::sse2});
  const Body& body = solver.state().bodies[0];
  const BodyIntegrals sum = remeshed::sum_particles<double, 2>(body, reference_point);
  EXPECT_NEAR(sum.mass, 0.01 * static_cast<double>(solver.particles()), 1e-13);
  EXPECT_NEAR(2 * sum.kinetic_energy, omega * sum.angular_momentum[2], 1e-12);
}

}  // namespace
}  // namespace pliant::test
