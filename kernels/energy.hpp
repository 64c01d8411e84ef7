#pragma once

#include <cmath>

#include "kernels/layout.hpp"
#include "kernels/material.hpp"

/// Strain energy of one particle, in plain scalars, for measurements.
namespace pliant::kernels {

/// Elastic energy per current volume of the linear laws at deviatoric stress `s`, (RP.62).
template <class T, int D>
T linear_energy(const Material<T>& material, const T* s, T density) {
  const T j = material.density / density;
  const T volumetric =
      material.model == Model::linear ? j - 1 - std::log(j) : j * std::log(j) - j + 1;
  T square = 0, trace = 0;
  for (int i = 0; i < D; ++i) {
    trace += s[symmetric_index<D>(i, i)];
    for (int k = 0; k < D; ++k) square += s[symmetric_index<D>(i, k)] * s[symmetric_index<D>(i, k)];
  }
  if (D == 2) square += trace * trace;  // S_zz = -(S_xx + S_yy), (RP.11)
  return material.bulk_modulus * volumetric / j + square / (4 * material.shear_modulus);
}

/// Elastic energy per current volume of the reduced polynomial at deformation gradient `f`,
/// (RP.63).
template <class T, int D>
T polynomial_energy(const Material<T>& material, const T* f) {
  T square = D == 2 ? T(1) : T(0);  // tr F F^T, with F_33 = 1 in plane strain
  for (int c = 0; c < D * D; ++c) square += f[c] * f[c];
  T j;
  if constexpr (D == 2) {
    j = f[0] * f[3] - f[1] * f[2];
  } else {
    j = f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
        f[2] * (f[3] * f[7] - f[4] * f[6]);
  }
  const T excess = square * std::pow(j, T(-2) / T(3)) - 3;
  T energy = (j - 1) * (j - 1) / material.compressibility, power = 1;
  for (int n = 1; n <= material.order; ++n) {
    power *= excess;
    energy += material.coefficient[n - 1] * power;
  }
  return energy / j;
}

}  // namespace pliant::kernels
