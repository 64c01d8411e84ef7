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

/// tr F^T F and det F, with F_33 = 1 in plane strain.
template <class T>
struct Invariants {
  T square, determinant;
};

template <class T, int D>
Invariants<T> invariants_of(const T* f) {
  T square = D == 2 ? T(1) : T(0);
  for (int c = 0; c < D * D; ++c) square += f[c] * f[c];
  if constexpr (D == 2) {
    return {square, f[0] * f[3] - f[1] * f[2]};
  } else {
    return {square, f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
                        f[2] * (f[3] * f[7] - f[4] * f[6])};
  }
}

/// Elastic energy per undeformed volume of the reduced polynomial, (RP.63).
template <class T, int D>
T polynomial_energy(const Material<T>& material, const T* f) {
  const auto [square, j] = invariants_of<T, D>(f);
  const T excess = square * std::pow(j, T(-2) / T(3)) - 3;
  T energy = (j - 1) * (j - 1) / material.compressibility, power = 1;
  for (int n = 1; n <= material.order; ++n) {
    power *= excess;
    energy += material.coefficient[n - 1] * power;
  }
  return energy;
}

/// psi of (PB.6).
template <class T, int D>
T neo_hookean_energy(const Material<T>& material, const T* f) {
  const auto [square, j] = invariants_of<T, D>(f);
  return material.shear_modulus * ((square - 3) / 2 - std::log(j)) +
         lame_modulus(material) / 2 * (j - 1) * (j - 1);
}

/// psi of (PB.7).
template <class T, int D>
T st_venant_kirchhoff_energy(const Material<T>& material, const T* f) {
  T trace = 0, square = 0;
  for (int i = 0; i < D; ++i) {
    for (int k = 0; k < D; ++k) {
      T c = i == k ? T(-1) : T(0);
      for (int l = 0; l < D; ++l) c += f[D * l + i] * f[D * l + k];
      square += c * c / 4;
      if (i == k) trace += c / 2;
    }
  }
  return lame_modulus(material) / 2 * trace * trace + material.shear_modulus * square;
}

/// Elastic energy of a material that carries F, per undeformed volume [J/m^3].
template <class T, int D>
T hyperelastic_energy(const Material<T>& material, const T* f) {
  switch (material.model) {
    case Model::neo_hookean:
      return neo_hookean_energy<T, D>(material, f);
    case Model::st_venant_kirchhoff:
      return st_venant_kirchhoff_energy<T, D>(material, f);
    default:
      return polynomial_energy<T, D>(material, f);
  }
}

}  // namespace pliant::kernels
