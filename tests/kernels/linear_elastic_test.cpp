#include "kernels/linear_elastic.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

namespace pliant::kernels {
namespace {

using P = xsimd::batch<double, xsimd::sse2>;
constexpr double mu = 3.7;

template <int D>
using Tensor = Eigen::Matrix<double, D, D>;

template <int D>
Tensor<D> rate_of(const Tensor<D>& s, const Tensor<D>& gradient) {
  P packed[symmetric_components<D>], velocity[D][D], rate[symmetric_components<D>];
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      packed[symmetric_index<D>(i, j)] = P(s(i, j));
      velocity[i][j] = P(gradient(i, j));
    }
  }
  jaumann_rate<P, D>(P(mu), packed, velocity, rate);
  Tensor<D> result;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) result(i, j) = rate[symmetric_index<D>(i, j)].get(0);
  }
  return result;
}

template <int D>
Tensor<D> symmetric_random() {
  const Tensor<D> a = Tensor<D>::Random();
  return a + a.transpose();
}

/// A material whose stress rotates with the body by exp(W t) while it grows by Hooke's law: the
/// derivative at t = 0 by a central difference, in three dimensions with e_zz = 0 if D is 2.
template <int D>
Tensor<D> rate_of_motion(const Tensor<D>& s, const Tensor<D>& gradient) {
  const Tensor<D> strain = (gradient + gradient.transpose()) / 2;
  const Tensor<D> spin = (gradient - gradient.transpose()) / 2;
  const Tensor<D> hooke = 2 * mu * (strain - strain.trace() / 3 * Tensor<D>::Identity());
  const auto at = [&](double t) -> Tensor<D> {
    const Tensor<D> turn = (spin * t).exp();
    return turn * (s + hooke * t) * turn.transpose();
  };
  const double step = 1e-5;
  return (at(step) - at(-step)) / (2 * step);
}

template <int D>
void expect_rate_of_exact_motion() {
  for (int trial = 0; trial < 20; ++trial) {
    const Tensor<D> s = symmetric_random<D>(), gradient = Tensor<D>::Random();
    // Error of the difference: step^2 = 1e-10 times third derivatives of order 10; rounding
    // 1e-16/step.
    EXPECT_LT((rate_of<D>(s, gradient) - rate_of_motion<D>(s, gradient)).norm(), 1e-8);
  }
}

TEST(linear_elastic, stress_rate_is_that_of_an_exact_motion) {
  expect_rate_of_exact_motion<2>();
  expect_rate_of_exact_motion<3>();
}

template <int D>
double error_after_a_turn(int steps) {
  Tensor<D> spin = Tensor<D>::Random();
  spin = (spin - spin.transpose()).eval();
  const Tensor<D> start = symmetric_random<D>();
  Tensor<D> s = start;
  const double dt = 1. / steps;
  for (int step = 0; step < steps; ++step) {
    const Tensor<D> k1 = rate_of<D>(s, spin), k2 = rate_of<D>(s + dt / 2 * k1, spin);
    const Tensor<D> k3 = rate_of<D>(s + dt / 2 * k2, spin), k4 = rate_of<D>(s + dt * k3, spin);
    s += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const Tensor<D> turn = spin.exp();
  return (s - turn * start * turn.transpose()).norm();
}

TEST(linear_elastic, stress_of_a_rigidly_rotating_particle_rotates_with_it) {
  // Runge-Kutta: (dt w)^4 = (2/400)^4 = 6e-10 times a constant below one.
  EXPECT_LT(error_after_a_turn<2>(400), 1e-9);
  EXPECT_LT(error_after_a_turn<3>(400), 1e-9);
}

TEST(linear_elastic, pressures_follow_their_laws) {
  for (double x = 0.5; x < 2; x += 0.01) {
    EXPECT_DOUBLE_EQ(linear_pressure<Model::linear>(P(5.), P(x)).get(0), 5 * (x - 1));
    EXPECT_NEAR(linear_pressure<Model::linear_logarithmic>(P(5.), P(x)).get(0), 5 * std::log(x),
                1e-14);
  }
}

TEST(linear_elastic, wave_speed_is_that_of_plane_pressure_waves) {
  Material<double> material;
  material.density = 2;
  material.bulk_modulus = 5;
  material.shear_modulus = mu;
  // At rest both laws are Hooke's law: rho0 c^2 = K + 4 mu/3.
  const double at_rest = (5 + 4 * mu / 3) / 2;
  EXPECT_DOUBLE_EQ(linear_wave_speed2<Model::linear>(material, P(2.)).get(0), at_rest);
  EXPECT_DOUBLE_EQ(linear_wave_speed2<Model::linear_logarithmic>(material, P(2.)).get(0), at_rest);
  // Compressed, c^2 = dp/drho + 4 mu/(3 rho), with dp/drho = K/rho0 or K/rho.
  EXPECT_DOUBLE_EQ(linear_wave_speed2<Model::linear>(material, P(3.)).get(0), 5. / 2 + 4 * mu / 9);
  EXPECT_DOUBLE_EQ(linear_wave_speed2<Model::linear_logarithmic>(material, P(3.)).get(0),
                   5. / 3 + 4 * mu / 9);
}

}  // namespace
}  // namespace pliant::kernels
