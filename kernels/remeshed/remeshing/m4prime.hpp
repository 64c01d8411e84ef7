#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// M4' of (RP.31) at the four nodes around a particle; `fraction` in [0, 1) is its distance from
/// the second node, over h.
template <class P>
inline void m4prime(const P& fraction, P (&weight)[4]) {
  using T = Scalar<P>;
  const P one(T(1)), half(T(0.5));
  const P x = fraction, y = one - fraction;
  // (1 - s)(2 - s)^2/2 at s = 1 + x and s = 1 + y; 1 - 5 s^2/2 + 3 s^3/2 at s = x and s = y.
  weight[0] = -half * x * (y * y);
  weight[1] = fused(fused(P(T(1.5)), x, P(T(-2.5))), x * x, one);
  weight[2] = fused(fused(P(T(1.5)), y, P(T(-2.5))), y * y, one);
  weight[3] = -half * y * (x * x);
}

}  // namespace pliant::kernels
