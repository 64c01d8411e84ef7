#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "engine/lattice/lattice.hpp"

/// Forces of a method on the undeformed body, compared with its energy and its invariants.
namespace pliant::test {

/// [slot] forces on the nodes of the first body [N], from the change of velocity in a step so short
/// that nothing moves.
template <int D, class Solver>
std::vector<Eigen::Matrix<double, D, 1>> forces_on_nodes(Solver& solver) {
  constexpr double dt = 1e-9;
  auto& body = solver.state().bodies[0];
  for (auto& component : body.velocity) std::fill_n(component.get(), body.slots, 0);
  solver.step(dt);
  std::vector<Eigen::Matrix<double, D, 1>> force(body.slots);
  for (std::int64_t s = 0; s < body.slots; ++s) {
    for (int a = 0; a < D; ++a) force[s][a] = body.velocity[a][s] * body.mass[s] / dt;
  }
  return force;
}

/// Expects f = -dU/du at a node, by central differences.
template <int D, class Solver>
void expect_slope_of_energy(Solver& solver, std::int64_t slot,
                            const Eigen::Matrix<double, D, 1>& force, double tolerance) {
  auto& body = solver.state().bodies[0];
  for (int a = 0; a < D; ++a) {
    double& d = body.displacement[a][slot];
    const double here = d, step = 1e-5;
    d = here + step;
    const double above = solver.integrals().strain_energy;
    d = here - step;
    const double below = solver.integrals().strain_energy;
    d = here;
    EXPECT_NEAR(force[a], -(above - below) / (2 * step), tolerance);
  }
}

/// Expects that forces and torques on a free body sum to zero.
template <int D, class Body>
void expect_no_push_and_no_turn(const Body& body,
                                const std::vector<Eigen::Matrix<double, D, 1>>& force) {
  Eigen::Matrix<double, D, 1> sum = Eigen::Matrix<double, D, 1>::Zero();
  Eigen::Matrix<double, D, D> torque = Eigen::Matrix<double, D, D>::Zero();
  double size = 0;
  for (std::int64_t s = 0; s < body.slots; ++s) {
    const Point<D> at = body.position(s);
    const Eigen::Map<const Eigen::Matrix<double, D, 1>> x(at.data());
    sum += force[s];
    torque += x * force[s].transpose() - force[s] * x.transpose();
    size += force[s].norm();
  }
  EXPECT_LT(sum.norm(), 1e-14 * size);
  EXPECT_LT(torque.norm(), 2e-14 * size);
}

}  // namespace pliant::test
