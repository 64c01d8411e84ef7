#pragma once

#include <array>
#include <cstdint>

#include "kernels/layout.hpp"
#include "kernels/pack.hpp"

/// Second Piola-Kirchhoff stresses and their first Piola-Kirchhoff stresses.
namespace pliant::kernels {

/// p += F S.
template <class P, int D>
inline void add_pulled_back(const P (&f)[D * D], const P (&s)[symmetric_components<D>],
                            P (&p)[D * D]) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
#pragma GCC unroll 3
      for (int k = 0; k < D; ++k) {
        p[D * i + j] = fused(f[D * i + k], s[symmetric_index<D>(k, j)], p[D * i + j]);
      }
    }
  }
}

/// p += F S0 of the slots from `slot` on, (TL.14).
template <class P, int D>
inline void add_initial_stress(
    const std::array<const Scalar<P>*, symmetric_components<D>>& initial_stress, std::int64_t slot,
    const P (&f)[D * D], P (&p)[D * D]) {
  P s[symmetric_components<D>];
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) s[c] = load<P>(initial_stress[c] + slot);
  add_pulled_back<P, D>(f, s, p);
}

}  // namespace pliant::kernels
