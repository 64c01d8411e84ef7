#pragma once

#include "kernels/cofactor.hpp"
#include "kernels/hyperelastic_material.hpp"
#include "kernels/law.hpp"
#include "kernels/second_piola.hpp"

/// First Piola-Kirchhoff stresses of the methods on the undeformed body, row-major.
namespace pliant::kernels {

/// E = (F^T F - I)/2, in the order of symmetric_index.
template <class P, int D>
inline void green_strain(const P (&f)[D * D], P (&e)[symmetric_components<D>]) {
  using T = Scalar<P>;
  const P half(T(0.5));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      P c = f[i] * f[j];
#pragma GCC unroll 3
      for (int k = 1; k < D; ++k) c = fused(f[D * k + i], f[D * k + j], c);
      e[symmetric_index<D>(i, j)] = half * (i == j ? c - P(T(1)) : c);
    }
  }
}

/// S = lambda tr(E) I + 2 mu E.
template <class P, int D>
inline void hooke(const P& lame_modulus, const P& shear_modulus,
                  const P (&e)[symmetric_components<D>], P (&s)[symmetric_components<D>]) {
  P trace = e[symmetric_index<D>(0, 0)];
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) trace = trace + e[symmetric_index<D>(i, i)];
  const P twice = shear_modulus + shear_modulus;
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) s[c] = twice * e[c];
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    P& diagonal = s[symmetric_index<D>(i, i)];
    diagonal = fused(lame_modulus, trace, diagonal);
  }
}

/// P(F) of (PB.6), (PB.7), or (RP.9) with (TL.4).
template <ElasticLaw law, class P, int D>
inline void first_piola(const HyperelasticMaterial<Scalar<P>>& material, const P (&f)[D * D],
                        const P (&cof)[D * D], P (&p)[D * D]) {
  using T = Scalar<P>;
  if constexpr (law == ElasticLaw::neo_hookean) {
    const P mu(material.shear_modulus), j = determinant(f);
    const P factor = fused(P(material.lame_modulus), j - P(T(1)), P(T(0)) - mu / j);
#pragma GCC unroll 9
    for (int c = 0; c < D * D; ++c) p[c] = fused(mu, f[c], factor * cof[c]);
  } else if constexpr (law == ElasticLaw::st_venant_kirchhoff) {
    P e[symmetric_components<D>], s[symmetric_components<D>];
    green_strain<P, D>(f, e);
    hooke<P, D>(P(material.lame_modulus), P(material.shear_modulus), e, s);
    for (P& component : p) component = P(T(0));
    add_pulled_back<P, D>(f, s, p);
  } else {
    P sigma[symmetric_components<D>];
    Law<Model::reduced_polynomial, P, D>::stress(material.polynomial, f, P(T(1)), sigma);
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) {
        P stress = sigma[symmetric_index<D>(i, 0)] * cof[j];
#pragma GCC unroll 3
        for (int k = 1; k < D; ++k) {
          stress = fused(sigma[symmetric_index<D>(i, k)], cof[D * k + j], stress);
        }
        p[D * i + j] = stress;
      }
    }
  }
}

}  // namespace pliant::kernels
