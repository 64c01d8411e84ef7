#pragma once

#include "kernels/layout.hpp"
#include "kernels/pack.hpp"

namespace pliant::kernels {

/// B = F F^T of a row-major F, in the order of symmetric_index.
template <class P, int D>
inline void left_cauchy_green(const P (&f)[D * D], P (&b)[symmetric_components<D>]) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      P sum = f[i * D] * f[j * D];
#pragma GCC unroll 3
      for (int k = 1; k < D; ++k) sum = fused(f[i * D + k], f[j * D + k], sum);
      b[symmetric_index<D>(i, j)] = sum;
    }
  }
}

/// Upper bound of the largest eigenvalue of a symmetric tensor: mean + sqrt((D - 1)/D) times the
/// norm of the deviator; exact if the other eigenvalues are equal.
template <class P, int D>
inline P eigenvalue_bound(const P (&tensor)[symmetric_components<D>]) {
  using T = Scalar<P>;
  P mean = tensor[symmetric_index<D>(0, 0)], square(T(0));
#pragma GCC unroll 3
  for (int i = 1; i < D; ++i) mean = mean + tensor[symmetric_index<D>(i, i)];
  mean = mean * P(T(1) / T(D));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = i; j < D; ++j) {
      const P& component = tensor[symmetric_index<D>(i, j)];
      const P part = i == j ? component - mean : component;
      square = fused(i == j ? part : part + part, part, square);
    }
  }
  return mean + xsimd::sqrt(P(T(D - 1) / T(D)) * square);
}

}  // namespace pliant::kernels
