#pragma once

#include "kernels/gradient_sweep.hpp"

/// The dissipation of (RP.43): fourth differences of velocity and stress along the lattice lines,
/// which only see what the lattice does not resolve.
namespace pliant::kernels {

/// sum over the directions of delta^4 f, from the slots up to two away.
template <class P, int D, int F>
[[gnu::always_inline]] inline void fourth_differences(const SweepFields<Scalar<P>, D, F>& fields,
                                                      const std::int64_t* neighbour_row,
                                                      std::int64_t slot, P (&result)[F]) {
  using T = Scalar<P>;
  const P four(T(4)), centre(T(6 * D));
#pragma GCC unroll 16
  for (int f = 0; f < F; ++f) {
    P outer(T(0)), inner(T(0));
#pragma GCC unroll 3
    for (int axis = 0; axis < D; ++axis) {
#pragma GCC unroll 2
      for (int side = -1; side <= 1; side += 2) {
        const int along = axis == 0 ? side : 0;
        const int dy = axis == 1 ? side : 0, dz = axis == 2 ? side : 0;
        const T* next = fields.field[f] + slot + neighbour_row[row_index<D>(dy, dz)] + along;
        const T* second =
            fields.field[f] + slot + neighbour_row[row_index<D>(2 * dy, 2 * dz)] + 2 * along;
        inner = inner + load<P>(next);
        outer = outer + load<P>(second);
      }
    }
    result[f] = fused(centre, load<P>(fields.field[f] + slot), fused_minus(four, inner, outer));
  }
}

/// The strain rate that relaxes the stress at the rate -kappa delta^4 sigma: Hooke's law inverted.
/// A material that remembers its deformation (F) relaxes the pressure alone: relaxing its shear
/// would be creep.
template <class P, int D>
inline void relaxing_strain_rate(const Material<Scalar<P>>& material, Scalar<P> kappa,
                                 const P (&difference)[symmetric_components<D>],
                                 P (&strain_rate)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const T shear = material.shear_modulus;
  const T lame = material.bulk_modulus - shear * T(2) / T(3);
  P trace = difference[0];
  for (int i = 1; i < D; ++i) trace = trace + difference[symmetric_index<D>(i, i)];
  const P mean = trace * P(T(1) / T(D));
  const P volumetric = mean * P(-kappa / (T(D) * lame + 2 * shear));
  const P scale(material.model == Model::reduced_polynomial ? T(0) : -kappa / (2 * shear));
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) {
      const P& d = difference[symmetric_index<D>(i, j)];
      strain_rate[symmetric_index<D>(i, j)] =
          i == j ? fused(scale, d - mean, volumetric) : scale * d;
    }
  }
}

}  // namespace pliant::kernels
