#pragma once

#include "kernels/material.hpp"
#include "kernels/roots.hpp"

namespace pliant::kernels {

/// Pair weight omega of (RP.20) as a function of the squared distance [m^2]; zero outside the
/// support and finite at zero distance.
template <Kernel kernel, class P>
class PairWeight;

/// t = max(0, 1 - r^2/R^2) of (RP.16), (RP.17) and (RP.18), R the support.
template <class P>
class WithinSupport {
  using T = Scalar<P>;

 public:
  /// R^2 over h^2.
  WithinSupport(T spacing, T square) : per_support2_(1 / (square * spacing * spacing)) {}

  P operator()(const P& distance2) const {
    return xsimd::max(P(T(0)), fused_minus(distance2, per_support2_, P(T(1))));
  }

 private:
  P per_support2_;
};

/// (RP.15). Costs about two thirds more than the polynomial (RP.16).
template <class P>
class PairWeight<Kernel::quartic_spline, P> {
  using T = Scalar<P>;

 public:
  explicit PairWeight(T spacing) : per_spacing2_(1 / (spacing * spacing)) {}

  P operator()(const P& distance2) const {
    const P s2 = distance2 * per_spacing2_;
    const P inverse = inverse_square_root(s2);
    const P s = s2 * inverse;
    const P a = xsimd::max(P(T(0)), P(T(2.5)) - s);
    const P b = xsimd::max(P(T(0)), P(T(1.5)) - s);
    const P outer = fused_minus(P(T(5)) * b, b * b, a * a * a) * (inverse * P(T(1) / T(6)));
    // Below s = 1/2 the three cubes cancel to this polynomial, which has no pole.
    return xsimd::select(s2 < P(T(0.25)), P(T(1.25)) - s2, outer);
  }

 private:
  P per_spacing2_;
};

/// (RP.16), a fit to (RP.15) divided by its value at zero.
template <class P>
class PairWeight<Kernel::quartic_spline_fit, P> {
  using T = Scalar<P>;

 public:
  explicit PairWeight(T spacing) : within_(spacing, T(6.25)) {}

  P operator()(const P& distance2) const {
    const P t = within_(distance2);
    const P series = fused(fused(P(T(2.5554)), t, P(T(-2.31468))), t, P(T(0.76443)));
    return (t * t) * (t * series);
  }

 private:
  WithinSupport<P> within_;
};

/// (RP.17)
template <class P>
class PairWeight<Kernel::compact, P> {
  using T = Scalar<P>;

 public:
  explicit PairWeight(T spacing) : within_(spacing, T(3.0625)) {}

  P operator()(const P& distance2) const {
    const P t = within_(distance2);
    return (t * t) * (t * t);
  }

 private:
  WithinSupport<P> within_;
};

/// (RP.18): the fourth moments vanish on square and cubic lattices. It is negative between the
/// second neighbours along the axes and those between them. Its moment matrix therefore needs
/// particles that are still near their slots.
template <class P>
class PairWeight<Kernel::fourth_order, P> {
  using T = Scalar<P>;

 public:
  explicit PairWeight(T spacing) : within_(spacing, T(6.25)) {}

  P operator()(const P& distance2) const {
    const P t = within_(distance2);
    constexpr double coefficients[] = {-30.394221495264024, 21.979141703042178, -6.642571385553331,
                                       0.6355763142948405};
    P series(T(15.422074863480338));
#pragma GCC unroll 4
    for (const double c : coefficients) series = fused(series, t, P(T(c)));
    return (t * t) * series;
  }

 private:
  WithinSupport<P> within_;
};

}  // namespace pliant::kernels
