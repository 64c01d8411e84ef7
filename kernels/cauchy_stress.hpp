#pragma once

#include "kernels/left_cauchy_green.hpp"
#include "kernels/material.hpp"

/// Cauchy stresses of (PB.6) and (PB.7), for particles that carry F.
namespace pliant::kernels {

/// Stress and wave speeds of one law; in 2D of plane strain.
template <class P, int D>
struct CauchyStress {
  P sigma[symmetric_components<D>];  ///< sigma [Pa]
  P zz;                              ///< sigma_zz in 2D; unused in 3D [Pa]
  P wave_modulus;                    ///< upper bound of rho c^2 [Pa], (RP.111)

  /// -tr(sigma)/3 [Pa]
  P pressure() const {
    P trace = D == 2 ? zz : P(Scalar<P>(0));
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) trace = trace + sigma[symmetric_index<D>(i, i)];
    return trace * P(Scalar<P>(-1) / Scalar<P>(3));
  }
};

/// sigma = mu/J (B - I) + lambda (J - 1) I of (PB.6).
template <class P, int D>
inline CauchyStress<P, D> neo_hookean_stress(const Material<Scalar<P>>& material, const P& jacobian,
                                             const P (&b)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const P mu(material.shear_modulus), lambda(lame_modulus(material)), one(T(1));
  const P factor = mu / jacobian;
  CauchyStress<P, D> stress;
  stress.zz = lambda * (jacobian - one);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const int c = symmetric_index<D>(i, j);
      stress.sigma[c] = i == j ? fused(factor, b[c] - one, stress.zz) : factor * b[c];
    }
  }
  const P volumetric = xsimd::max(P(T(0)), fused(lambda * jacobian, jacobian, mu));
  stress.wave_modulus = fused(mu, eigenvalue_bound<P, D>(b), volumetric) / jacobian;
  return stress;
}

/// sigma = [(lambda/2 (tr B - 3) - mu) B + mu B^2]/J of (PB.7).
template <class P, int D>
inline CauchyStress<P, D> st_venant_kirchhoff_stress(const Material<Scalar<P>>& material,
                                                     const P& jacobian,
                                                     const P (&b)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const P mu(material.shear_modulus), lambda(lame_modulus(material)), one(T(1));
  const P inverse = one / jacobian;
  P excess = b[symmetric_index<D>(0, 0)] - one;
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) excess = excess + (b[symmetric_index<D>(i, i)] - one);
  CauchyStress<P, D> stress;
  const P volumetric = P(T(0.5)) * lambda * excess;  // lambda tr E
  stress.zz = volumetric * inverse;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const int c = symmetric_index<D>(i, j);
      // B^2 - B = B (B - I), without the difference of two large numbers at small strain.
      P square = b[symmetric_index<D>(i, 0)] *
                 (j == 0 ? b[symmetric_index<D>(0, j)] - one : b[symmetric_index<D>(0, j)]);
#pragma GCC unroll 3
      for (int k = 1; k < D; ++k) {
        const P& other = b[symmetric_index<D>(k, j)];
        square = fused(b[symmetric_index<D>(i, k)], k == j ? other - one : other, square);
      }
      stress.sigma[c] = inverse * fused(volumetric, b[c], mu * square);
    }
  }
  const P bound = eigenvalue_bound<P, D>(b);
  const P elastic = xsimd::max(lambda + mu + mu, mu) * bound * bound;
  stress.wave_modulus =
      fused(elastic, inverse, xsimd::max(P(T(0)), eigenvalue_bound<P, D>(stress.sigma)));
  return stress;
}

}  // namespace pliant::kernels
