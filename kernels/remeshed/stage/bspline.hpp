#pragma once

#include <numbers>

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// w of (RP.14) at s = r/h >= 0.
template <class P>
inline P bspline(const P& s) {
  using T = Scalar<P>;
  const auto fourth_power_below = [&s](T end) {
    const P x = xsimd::max(P(T(0)), P(end) - s);
    return (x * x) * (x * x);
  };
  const P sum = fused_minus(P(T(5)), fourth_power_below(T(1.5)), fourth_power_below(T(2.5)));
  return fused(P(T(10)), fourth_power_below(T(0.5)), sum) * P(T(1) / T(24));
}

/// n_d of (RP.14), which makes the integral of W equal to 1.
template <int D>
inline constexpr double bspline_normalisation = D == 1   ? 1
                                                : D == 2 ? 2304 / (1199 * std::numbers::pi)
                                                         : 6 / (5 * std::numbers::pi);

}  // namespace pliant::kernels
