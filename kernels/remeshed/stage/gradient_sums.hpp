#pragma once

#include "kernels/remeshed/stage/arguments.hpp"
#include "kernels/remeshed/stage/moment.hpp"

/// Sums of a sweep over neighbours, and the gradients that follow from them.
namespace pliant::kernels {

/// Sums for A of a pack.
template <class P, int D>
struct MomentSums {
  P moment[symmetric_components<D>];

  MomentSums() {
    for (P& a : moment) a = P(Scalar<P>(0));
  }

  [[gnu::always_inline]] void add(const P (&weighted)[D], const P (&d)[D]) {
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
      for (int j = i; j < D; ++j) {
        P& a = moment[symmetric_index<D>(i, j)];
        a = fused(weighted[i], d[j], a);
      }
    }
  }
};

/// Sums for H of a pack.
template <class P, int D, int F>
struct SlopeSums {
  P slope[F][D];

  SlopeSums() {
    for (auto& row : slope) {
      for (P& h : row) h = P(Scalar<P>(0));
    }
  }

  [[gnu::always_inline]] void add(const P (&weighted)[D], const P (&)[D],
                                  const P (&difference)[F]) {
#pragma GCC unroll 9
    for (int f = 0; f < F; ++f) {
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) slope[f][i] = fused(weighted[i], difference[f], slope[f][i]);
    }
  }
};

/// Sums for A and H.
template <class P, int D, int F>
struct GradientSums : MomentSums<P, D>, SlopeSums<P, D, F> {
  [[gnu::always_inline]] void add(const P (&weighted)[D], const P (&d)[D],
                                  const P (&difference)[F]) {
    MomentSums<P, D>::add(weighted, d);
    SlopeSums<P, D, F>::add(weighted, d, difference);
  }
};

/// A^-1, or for (RP.19) the diagonal matrix of n_p.
template <Gradient gradient, class P, int components>
inline void invert_moment(const P (&moment)[components], P (&inverse)[components]) {
  if constexpr (gradient == Gradient::normalised) {
    invert_diagonal(moment, inverse);
  } else {
    invert_symmetric(moment, inverse);
  }
}

/// Gradients of F fields from their sums and the inverse of A.
template <class P, int D, int F>
inline void solve(const P (&inverse)[symmetric_components<D>], const SlopeSums<P, D, F>& sums,
                  P (&gradient)[F][D]) {
#pragma GCC unroll 16
  for (int f = 0; f < F; ++f) {
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      P value = inverse[symmetric_index<D>(i, 0)] * sums.slope[f][0];
#pragma GCC unroll 3
      for (int j = 1; j < D; ++j) {
        value = fused(inverse[symmetric_index<D>(i, j)], sums.slope[f][j], value);
      }
      gradient[f][i] = value;
    }
  }
}

/// The same with A; not finite where the neighbours do not span D directions.
template <Gradient of = Gradient::moment_matrix, class P, int D, int F>
inline void solve(const GradientSums<P, D, F>& sums, P (&gradient)[F][D]) {
  P inverse[symmetric_components<D>];
  invert_moment<of>(sums.moment, inverse);
  solve<P, D, F>(inverse, sums, gradient);
}

}  // namespace pliant::kernels
