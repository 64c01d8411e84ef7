#pragma once

#include "kernels/material.hpp"
#include "kernels/roots.hpp"

namespace pliant::kernels {

/// dS/dt of (RP.3) at deviatoric stress S and velocity gradient du_i/dx_j. In plane strain (2D)
/// S_zz = -(S_xx + S_yy), and the trace is that in the plane (RP.11).
template <class P, int D>
inline void jaumann_rate(const P& shear_modulus, const P (&s)[symmetric_components<D>],
                         const P (&gradient)[D][D], P (&rate)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const P half(T(0.5));
  P trace = gradient[0][0];
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) trace = trace + gradient[i][i];
  P spin[D][D];
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) spin[i][j] = half * (gradient[i][j] - gradient[j][i]);
  }
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      P strain = half * (gradient[i][j] + gradient[j][i]);
      if (i == j) strain = fused_minus(P(T(1) / T(3)), trace, strain);
      // W S - S W = W S + (W S)^T, because W is antisymmetric and S symmetric.
      P turned = P(T(0));
#pragma GCC unroll 3
      for (int k = 0; k < D; ++k) {
        if (k != i) turned = fused(spin[i][k], s[symmetric_index<D>(k, j)], turned);
        if (k != j) turned = fused(spin[j][k], s[symmetric_index<D>(k, i)], turned);
      }
      rate[symmetric_index<D>(i, j)] = fused(P(T(2)) * shear_modulus, strain, turned);
    }
  }
}

/// p of (RP.5) or (RP.6) for a bulk modulus and the relative density rho/rho0.
template <Model model, class P>
inline P linear_pressure(const P& bulk_modulus, const P& relative_density) {
  if constexpr (model == Model::linear) {
    return bulk_modulus * (relative_density - P(Scalar<P>(1)));
  } else {
    return bulk_modulus * logarithm(relative_density);
  }
}

/// c^2 of (RP.12).
template <Model model, class P>
inline P linear_wave_speed2(const Material<Scalar<P>>& material, const P& density) {
  using T = Scalar<P>;
  const T shear = material.shear_modulus * (T(4) / T(3));
  if constexpr (model == Model::linear) {
    return P(material.bulk_modulus / material.density) + P(shear) / density;
  } else {
    return P(material.bulk_modulus + shear) / density;
  }
}

}  // namespace pliant::kernels
