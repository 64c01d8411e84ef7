#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// cof F = J F^-T, row-major.
template <class P>
inline void cofactor(const P (&f)[4], P (&cof)[4]) {
  const P zero(Scalar<P>(0));
  cof[0] = f[3];
  cof[1] = zero - f[2];
  cof[2] = zero - f[1];
  cof[3] = f[0];
}

template <class P>
inline void cofactor(const P (&f)[9], P (&cof)[9]) {
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const int i1 = 3 * ((i + 1) % 3), i2 = 3 * ((i + 2) % 3);
#pragma GCC unroll 3
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      cof[3 * i + j] = fused_minus(f[i1 + j2], f[i2 + j1], f[i1 + j1] * f[i2 + j2]);
    }
  }
}

}  // namespace pliant::kernels
