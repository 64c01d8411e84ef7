#pragma once

#include "kernels/pack.hpp"
#include "kernels/remeshed/ghosts/fit_terms.hpp"

/// Coefficients of a ghost's fits from their terms, for one particle or, if V is a register, for
/// several.
namespace pliant::kernels {

template <class V>
struct FitCoefficients {
  V linear, constrained, surface;
};

/// q_0 + sum_a q_a r_a
template <class V, int D, class Terms>
inline V linear_terms(const Terms& q, const V (&r)[D]) {
  V sum = fused(V(q[1]), r[0], V(q[0]));
#pragma GCC unroll 3
  for (int a = 1; a < D; ++a) sum = fused(V(q[a + 1]), r[a], sum);
  return sum;
}

template <class V, class T, int D>
inline V fit_weight(const FitTerms<T, D>& terms, const V (&r)[D]) {
  V square = r[0] * r[0], along = V(terms.broad[0]) * r[0];
#pragma GCC unroll 3
  for (int a = 1; a < D; ++a) {
    square = fused(r[a], r[a], square);
    along = fused(V(terms.broad[a]), r[a], along);
  }
  const V bracket = fused(along, along, fused_minus(V(terms.steepness), square, V(T(1))));
  const V root = larger(bracket, V(T(0)));
  return root * root;
}

template <class V, class T, int D>
inline FitCoefficients<V> fit_coefficients(const FitTerms<T, D>& terms, const V (&r)[D],
                                           const V& phi) {
  const V w = fit_weight(terms, r);
  const V constrained = fused(V(terms.constrained[D + 1]), phi, linear_terms(terms.constrained, r));
  return {w * linear_terms(terms.linear, r), w * phi * constrained,
          w * linear_terms(terms.surface, r)};
}

}  // namespace pliant::kernels
