#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// dw/ds at s = r/h >= 0; dW/dx_i = n_d h^(-d-1) (x_i/r) dw/ds.
template <class P>
inline P bspline_slope(const P& s) {
  using T = Scalar<P>;
  const auto cube_below = [&s](T end) {
    const P x = xsimd::max(P(T(0)), P(end) - s);
    return x * x * x;
  };
  const P sum = fused_minus(P(T(5)), cube_below(T(1.5)), cube_below(T(2.5)));
  return fused(P(T(10)), cube_below(T(0.5)), sum) * P(T(-1) / T(6));
}

}  // namespace pliant::kernels
