#include "engine/remeshed/setup/initial_state.hpp"

#include <fmt/format.h>
#include <Eigen/LU>
#include <pliant/error.hpp>

#include <cmath>

#include "engine/method/decompositions.hpp"
#include "engine/method/hyperelastic.hpp"
#include "engine/method/initial_stress.hpp"

namespace pliant::remeshed {

namespace {

template <int D>
using Principal = Eigen::Matrix<double, D, 1>;

/// Principal Cauchy stresses at logarithmic stretches; plane strain in 2D.
template <int D>
Principal<D> principal_stresses(const kernels::HyperelasticMaterial<double>& material,
                                const Principal<D>& strain) {
  std::array<double, D* D> f = {};
  for (int i = 0; i < D; ++i) f[(D + 1) * i] = std::exp(strain[i]);
  const ElasticStress<D> elastic = elastic_stress<D>(material, f);
  Principal<D> stress;
  for (int i = 0; i < D; ++i) stress[i] = elastic.stress[kernels::symmetric_index<D>(i, i)];
  return stress;
}

/// Newton's method from the undeformed state; steps that increase the residual are halved.
template <int D>
bool find_strain(const kernels::HyperelasticMaterial<double>& material, const Principal<D>& stress,
                 Principal<D>& strain) {
  constexpr int most_steps = 60;
  constexpr double difference = 1e-6, close = 1e-11, largest = 0.2;
  const double unit = material.lame_modulus + 2 * material.shear_modulus;
  strain.setZero();
  Principal<D> residual = principal_stresses<D>(material, strain) - stress;
  for (int step = 0; step < most_steps; ++step) {
    if (residual.norm() <= close * unit) return true;
    Eigen::Matrix<double, D, D> slope;
    for (int i = 0; i < D; ++i) {
      Principal<D> up = strain, down = strain;
      up[i] += difference;
      down[i] -= difference;
      slope.col(i) = (principal_stresses<D>(material, up) - principal_stresses<D>(material, down)) /
                     (2 * difference);
    }
    Principal<D> change = -slope.partialPivLu().solve(residual);
    if (!change.allFinite()) return false;
    const double size = change.template lpNorm<Eigen::Infinity>();
    if (size > largest) change *= largest / size;
    Principal<D> next = residual;
    for (int halving = 0; halving < 30; ++halving, change /= 2) {
      next = principal_stresses<D>(material, strain + change) - stress;
      if (next.norm() < residual.norm()) break;
    }
    strain += change;
    residual = next;
  }
  return residual.norm() <= close * unit;
}

template <int D>
InitialState<D> stretched_state(const BodyCase& body, const Eigen::Matrix<double, D, D>& stress,
                                const Vector& x) {
  const Eigensystem<D> axes = eigensystem<D>(stress);
  Principal<D> strain;
  if (!find_strain<D>(hyperelastic_material(body), axes.values, strain)) {
    throw InputError(fmt::format(
        "body `{}`: no stretch of its material has the initial stress at ({:.4g}, {:.4g}, {:.4g}), "
        "whose largest component is {:.4g} Pa; use a smaller stress",
        body.name, x[0], x[1], x[2], stress.cwiseAbs().maxCoeff()));
  }
  const Principal<D> stretch = strain.array().exp();
  const Eigen::Matrix<double, D, D> f =
      axes.vectors * stretch.asDiagonal() * axes.vectors.transpose();
  InitialState<D> state;
  for (int c = 0; c < D * D; ++c) state.material[c] = f(c / D, c % D);
  state.density = body.material.density / stretch.prod();
  return state;
}

template <int D>
InitialState<D> linear_state(const BodyCase& body, const std::array<double, 6>& stress) {
  const auto s = [&stress](int i, int j) { return stress[kernels::symmetric_index<3>(i, j)]; };
  const kernels::Material<double>& m = body.material;
  const double pressure = -(s(0, 0) + s(1, 1) + s(2, 2)) / 3;
  InitialState<D> state;
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) {
      state.material[kernels::symmetric_index<D>(i, j)] = s(i, j) + (i == j ? pressure : 0);
    }
  }
  const double relative = pressure / m.bulk_modulus;
  state.density =
      m.density * (m.model == kernels::Model::linear ? 1 + relative : std::exp(relative));
  if (state.density > 0) return state;
  throw InputError(fmt::format(
      "body `{}`: its initial stress has a tension of {:.4g} Pa, more than its bulk modulus of "
      "{:.4g} Pa bears; use a smaller stress",
      body.name, -pressure, m.bulk_modulus));
}

}  // namespace

template <int D>
InitialState<D> state_under_stress(const BodyCase& body, const Vector& x) {
  const std::array<double, 6> stress = initial_stress(body, x, D);
  if (!kernels::carries_deformation(body.material.model)) {
    return linear_state<D>(body, stress);
  }
  Eigen::Matrix<double, D, D> tensor;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) tensor(i, j) = stress[kernels::symmetric_index<3>(i, j)];
  }
  return stretched_state<D>(body, tensor, x);
}

template InitialState<2> state_under_stress<2>(const BodyCase&, const Vector&);
template InitialState<3> state_under_stress<3>(const BodyCase&, const Vector&);

}  // namespace pliant::remeshed
