#pragma once

#include "kernels/first_piola.hpp"

/// The change of volume in the energies of the methods on the undeformed body.
namespace pliant::kernels {

/// theta of (FE.2).
template <ElasticLaw law, class P, int D>
inline P dilatation(const P (&f)[D * D]) {
  using T = Scalar<P>;
  if constexpr (law == ElasticLaw::st_venant_kirchhoff) {
    P e[symmetric_components<D>];
    green_strain<P, D>(f, e);
    P trace = e[symmetric_index<D>(0, 0)];
#pragma GCC unroll 3
    for (int i = 1; i < D; ++i) trace = trace + e[symmetric_index<D>(i, i)];
    return trace;
  } else {
    return determinant(f) - P(T(1));
  }
}

/// piola += pressure dtheta/dF.
template <ElasticLaw law, class P, int D>
inline void add_volumetric_stress(const P& pressure, const P (&f)[D * D], const P (&cof)[D * D],
                                  P (&piola)[D * D]) {
#pragma GCC unroll 9
  for (int c = 0; c < D * D; ++c) {
    const P slope = law == ElasticLaw::st_venant_kirchhoff ? f[c] : cof[c];
    piola[c] = fused(pressure, slope, piola[c]);
  }
}

}  // namespace pliant::kernels
