#pragma once

#include "kernels/left_cauchy_green.hpp"
#include "kernels/material.hpp"
#include "kernels/roots.hpp"

namespace pliant::kernels {

/// dF/dt = (grad u) F, (RP.8); F is row-major.
template <class P, int D>
inline void deformation_rate(const P (&f)[D * D], const P (&gradient)[D][D], P (&rate)[D * D]) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      P value = gradient[i][0] * f[j];
#pragma GCC unroll 3
      for (int k = 1; k < D; ++k) value = fused(gradient[i][k], f[k * D + j], value);
      rate[i * D + j] = value;
    }
  }
}

template <class P>
inline P determinant(const P (&f)[4]) {
  return fused_minus(f[1], f[2], f[0] * f[3]);
}

template <class P>
inline P determinant(const P (&f)[9]) {
  const P x = fused_minus(f[5], f[7], f[4] * f[8]);
  const P y = fused_minus(f[5], f[6], f[3] * f[8]);
  const P z = fused_minus(f[4], f[6], f[3] * f[7]);
  return fused(f[2], z, fused_minus(f[1], y, f[0] * x));
}

/// The strain that determines the stress and the wave speed of (RP.9).
template <class P, int D>
struct IsochoricStrain {
  P volume_ratio;                       ///< J
  P deviator[symmetric_components<D>];  ///< dev B
  P deviator_zz;                        ///< for plane strain (RP.11); unused in 3D
  P excess;                             ///< I1 - 3
};

template <class P, int D>
inline IsochoricStrain<P, D> isochoric_strain(const P (&f)[D * D]) {
  using T = Scalar<P>;
  IsochoricStrain<P, D> strain;
  strain.volume_ratio = determinant(f);
  const P root = inverse_cube_root(strain.volume_ratio);
  const P scale = root * root;
  left_cauchy_green<P, D>(f, strain.deviator);
  P trace = D == 2 ? scale : P(T(0));
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) strain.deviator[c] = strain.deviator[c] * scale;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) trace = trace + strain.deviator[symmetric_index<D>(i, i)];
  const P mean = trace * P(T(1) / T(3));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    P& diagonal = strain.deviator[symmetric_index<D>(i, i)];
    diagonal = diagonal - mean;
  }
  strain.deviator_zz = scale - mean;
  strain.excess = trace - P(T(3));
  return strain;
}

/// W1 = sum n C_n0 (I1 - 3)^(n-1), and W2 = dW1/dI1, of (RP.12) by Horner's rule.
template <class P>
inline void energy_derivatives(const Material<Scalar<P>>& material, const P& excess, P& first,
                               P& second) {
  using T = Scalar<P>;
  first = P(T(0));
  second = P(T(0));
  for (int n = material.order; n >= 1; --n) {
    if (n >= 2) second = fused(second, excess, P(T(n * (n - 1)) * material.coefficient[n - 1]));
    first = fused(first, excess, P(T(n) * material.coefficient[n - 1]));
  }
}

/// p of (RP.9).
template <class P>
inline P polynomial_pressure(const Material<Scalar<P>>& material, const P& volume_ratio) {
  using T = Scalar<P>;
  return P(T(2) / material.compressibility) * (P(T(1)) - volume_ratio);
}

/// S of (RP.9).
template <class P, int D>
inline void polynomial_deviator(const Material<Scalar<P>>& material,
                                const IsochoricStrain<P, D>& strain,
                                P (&s)[symmetric_components<D>]) {
  P first, second;
  energy_derivatives(material, strain.excess, first, second);
  const P factor = (first + first) / strain.volume_ratio;
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) s[c] = factor * strain.deviator[c];
}

/// Upper bound of c^2, (RP.12).
template <class P, int D>
inline P polynomial_wave_speed2(const Material<Scalar<P>>& material,
                                const IsochoricStrain<P, D>& strain, const P& density) {
  using T = Scalar<P>;
  P first, second;
  energy_derivatives(material, strain.excess, first, second);
  P norm2 = D == 2 ? strain.deviator_zz * strain.deviator_zz : P(T(0));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const P& b = strain.deviator[symmetric_index<D>(i, j)];
      norm2 = fused(i == j ? b : b + b, b, norm2);
    }
  }
  const P isochoric =
      fused(P(T(10) / T(9)) * (strain.excess + P(T(3))), first, P(T(8) / T(3)) * second * norm2);
  return fused(P(T(2) / material.compressibility), strain.volume_ratio,
               isochoric / strain.volume_ratio) /
         density;
}

}  // namespace pliant::kernels
