#include <gtest/gtest.h>

#include <numbers>

#include "engine/total_lagrangian/nodes.hpp"
#include "tests/engine/geometry/meshes.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

namespace pliant::test {
namespace {

TEST(total_lagrangian, a_tumbling_block_keeps_momentum_to_rounding_and_its_energy) {
  const Case settings = tests::read_text(
      free_block(3) + "velocity = [\"3*y + sin(4*x)\", \"1 - 3*x\", \"2*cos(3*y)\"]\n");
  LagrangianSolver<3> solver(settings, {2, kernels::widest_supported()});
  const BodyIntegrals start = solver.integrals();
  EXPECT_NEAR(start.mass, 1, 1e-12);
  advance_until(solver, 1);
  const BodyIntegrals end = solver.integrals();
  EXPECT_EQ(end.mass, start.mass);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(end.momentum[axis], start.momentum[axis], 1e-12);
    // Hourglass forces act along the lines between particles only on average.
    EXPECT_NEAR(end.angular_momentum[axis], start.angular_momentum[axis], 0.01);
  }
  EXPECT_GT(end.strain_energy, 0.01 * end.kinetic_energy);
  EXPECT_NEAR(end.kinetic_energy + end.strain_energy, start.kinetic_energy + start.strain_energy,
              0.01 * start.kinetic_energy);
}

/// Relative errors of volume and surface of a ball of radius 1.
std::pair<double, double> errors_of_ball(const std::string& spacing) {
  const Case settings = tests::read_text(R"(
method = "total_lagrangian"
dimension = 3
discretisation = { spacing = 0.1 }
time = { end = 1 }
[[body]]
name = "ball"
geometry = { shape = "ball", centre = [0.03, 0.01, 0], radius = 1 }
material = { model = "reduced_polynomial", density = 2, coefficients = [1], compressibility = 0.1 }
[[measurement]]
name = "volume"
kind = "volume"
[[measurement]]
name = "surface"
kind = "surface_area"
)",
                                         {"discretisation.spacing=" + spacing});
  LagrangianSolver<3> solver(settings, {1, kernels::widest_supported()});
  const auto values = solver.measure();
  return {values[0] / (4 * std::numbers::pi / 3) - 1, values[1] / (4 * std::numbers::pi) - 1};
}

// The surface is linear within a cell and between its edges at most h^2/(8 R) too far in, in each
// of its two directions: the area lost is 2/R times that.
TEST(total_lagrangian, a_ball_has_its_volume_and_its_surface_to_second_order) {
  const auto [volume, surface] = errors_of_ball("0.1");
  const auto [finer_volume, finer_surface] = errors_of_ball("0.05");
  EXPECT_LT(std::abs(volume), 2e-4);
  EXPECT_LT(std::abs(finer_volume), 2e-4);
  EXPECT_LT(std::abs(surface), 2 * 3 * 0.01 / 8);
  EXPECT_GT(surface / finer_surface, 3.5);
}

// Distances to meshes are interpolated linearly between the particles, with (TL.33).
TEST(total_lagrangian, a_ball_from_a_mesh_has_its_volume) {
  const Shape ball = tests::mesh_shape(tests::sphere_mesh(1, 4));
  for (const double h : {0.25, 0.2, 0.1}) {
    const Lattice<3> lattice{h, {0.013, 0.027, 0.041}};
    const total_lagrangian::Nodes<3> nodes(lattice, ball, bounding_box(ball));
    double volume = 0;
    nodes.for_each([&](const Cell<3>& cell) {
      if (nodes.has_cell(cell)) volume += nodes.fraction(cell) * h * h * h;
    });
    EXPECT_NEAR(volume, ball.mesh->volume(), 0.003 * volume) << h;
  }
}

TEST(total_lagrangian, pressure_all_around_pushes_a_body_nowhere) {
  const std::string squeezed = R"([[boundary]]
name = "water"
kind = "pressure"
geometry = { shape = "ball", centre = [0, 0, 0], radius = 9 }
pressure = "10*t"
)";
  const Case settings = tests::read_text(
      tests::with(free_block(3), R"({ shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] })",
                  R"({ shape = "ball", centre = [0.3, 0.2, 0.1], radius = 0.5 })") +
      squeezed);
  LagrangianSolver<3> solver(settings, {2, kernels::widest_supported()});
  advance_until(solver, 0.5);
  const BodyIntegrals end = solver.integrals();
  EXPECT_GT(end.strain_energy, 1e-3);
  for (const double momentum : end.momentum) EXPECT_NEAR(momentum, 0, 1e-12);
}

}  // namespace
}  // namespace pliant::test
