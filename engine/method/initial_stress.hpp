#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/case/case.hpp"
#include "kernels/layout.hpp"

namespace pliant {

/// Stress of a body's material at `x` at t = 0 [Pa], its components in the order of
/// symmetric_index<3>. In 2D sigma_zz is that of plane strain, nu (sigma_xx + sigma_yy). It is 0
/// for bodies without an initial stress.
std::array<double, 6> initial_stress(const BodyCase& body, const Vector& x, int dimension);

/// The components of initial_stress in D dimensions, in the order of symmetric_index<D>.
template <int D>
std::array<double, kernels::symmetric_components<D>> initial_stress_in(const BodyCase& body,
                                                                       const Vector& x) {
  const std::array<double, 6> full = initial_stress(body, x, D);
  std::array<double, kernels::symmetric_components<D>> stress;
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) {
      stress[kernels::symmetric_index<D>(i, j)] = full[kernels::symmetric_index<3>(i, j)];
    }
  }
  return stress;
}

/// Poisson's ratio at small strains.
double poissons_ratio(const BodyCase& body);

/// A constant second Piola-Kirchhoff stress S0: its work per undeformed volume, S0 : E, and its
/// part of the Cauchy stress, F S0 F^T/J (TL.14). `f` is row-major.
template <int D>
struct ConstantStress {
  double energy = 0;                                                 ///< [Pa]
  std::array<double, kernels::symmetric_components<D>> stress = {};  ///< [Pa]

  template <class S>
  ConstantStress(const S& s0, const std::array<double, D * D>& f, double volume_ratio) {
    const auto s = [&s0](int i, int j) -> double { return s0[kernels::symmetric_index<D>(i, j)]; };
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        double strain = i == j ? -0.5 : 0;
        for (int k = 0; k < D; ++k) strain += f[D * k + i] * f[D * k + j] / 2;
        energy += s(i, j) * strain;
        if (j < i) continue;
        double& sum = stress[kernels::symmetric_index<D>(i, j)];
        for (int k = 0; k < D; ++k) {
          for (int l = 0; l < D; ++l) sum += f[D * i + k] * s(k, l) * f[D * j + l] / volume_ratio;
        }
      }
    }
  }

  /// The mean pressure of this stress; plane strain has sigma_zz = nu (sigma_xx + sigma_yy).
  double pressure(const BodyCase& body) const {
    double trace = 0;
    for (int i = 0; i < D; ++i) trace += stress[kernels::symmetric_index<D>(i, i)];
    return -trace * (D == 2 ? 1 + poissons_ratio(body) : 1) / 3;
  }
};

/// A bound on the speed of waves at rest under the stresses [component][slot] [m/s]: tension makes
/// waves faster.
template <int D, class Stresses>
double wave_speed_under(const BodyCase& body, const Stresses& stresses, std::int64_t slots) {
  double largest = 0;
  for (std::int64_t slot = 0; slot < slots; ++slot) {
    for (int i = 0; i < D; ++i) {
      double row = 0;
      for (int j = 0; j < D; ++j) {
        row += std::abs(static_cast<double>(stresses[kernels::symmetric_index<D>(i, j)][slot]));
      }
      largest = std::max(largest, row);
    }
  }
  return std::hypot(kernels::wave_speed_at_rest(body.material),
                    std::sqrt(largest / body.material.density));
}

}  // namespace pliant
