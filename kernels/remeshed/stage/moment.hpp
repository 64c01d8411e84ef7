#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// Determinant of a symmetric D x D matrix, in the order of symmetric_index.
template <class P>
inline P symmetric_determinant(const P (&a)[3]) {
  return fused_minus(a[1], a[1], a[0] * a[2]);
}

template <class P>
inline P symmetric_determinant(const P (&a)[6]) {
  const P xx = fused_minus(a[4], a[4], a[3] * a[5]);
  const P xy = fused_minus(a[1], a[5], a[2] * a[4]);
  const P xz = fused_minus(a[2], a[3], a[1] * a[4]);
  return fused(a[2], xz, fused(a[1], xy, a[0] * xx));
}

/// Inverse of a symmetric D x D matrix, both in the order of symmetric_index. For a singular matrix
/// the result is not finite.
template <class P>
inline void invert_symmetric(const P (&a)[3], P (&inverse)[3]) {
  const P determinant = fused_minus(a[1], a[1], a[0] * a[2]);
  const P factor = P(Scalar<P>(1)) / determinant;
  inverse[0] = a[2] * factor;
  inverse[1] = -a[1] * factor;
  inverse[2] = a[0] * factor;
}

template <class P>
inline void invert_symmetric(const P (&a)[6], P (&inverse)[6]) {
  const P xx = fused_minus(a[4], a[4], a[3] * a[5]);
  const P xy = fused_minus(a[1], a[5], a[2] * a[4]);
  const P xz = fused_minus(a[2], a[3], a[1] * a[4]);
  const P determinant = fused(a[2], xz, fused(a[1], xy, a[0] * xx));
  const P factor = P(Scalar<P>(1)) / determinant;
  inverse[0] = xx * factor;
  inverse[1] = xy * factor;
  inverse[2] = xz * factor;
  inverse[3] = fused_minus(a[2], a[2], a[0] * a[5]) * factor;
  inverse[4] = fused_minus(a[0], a[4], a[1] * a[2]) * factor;
  inverse[5] = fused_minus(a[1], a[1], a[0] * a[3]) * factor;
}

/// Inverse of the diagonal of such a matrix, with zeros elsewhere. If weights contain v_q, the
/// diagonal of the moment matrix has 1/n_p of (RP.19).
template <class P, int components>
inline void invert_diagonal(const P (&a)[components], P (&inverse)[components]) {
  constexpr int D = components == 3 ? 2 : 3;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const int c = symmetric_index<D>(i, j);
      inverse[c] = i == j ? P(Scalar<P>(1)) / a[c] : P(Scalar<P>(0));
    }
  }
}

}  // namespace pliant::kernels
