#pragma once

#include "kernels/pack.hpp"

/// Small symmetric systems, one in each lane.
namespace pliant::kernels {

/// Solves M x = e for K right-hand sides by elimination with diagonal pivots.
template <class P, int N, int K>
class SymmetricSystem {
  using T = Scalar<P>;
  using Mask = typename P::batch_bool_type;

 public:
  P right[K][N];  ///< e, then the solution x

  /// Entry (i, j) of M, i <= j.
  P& at(int i, int j) { return i < j ? matrix_[i][j] : matrix_[j][i]; }

  /// Solves in place. Returns the lanes whose smallest pivot is above `least` times the largest.
  Mask solve(const P& least) {
    P smallest = P(T(0)), largest = P(T(0));
#pragma GCC unroll 4
    for (int s = 0; s < N; ++s) {
      bring_largest(s);
      const P pivot = at(s, s);
      smallest = s == 0 ? pivot : xsimd::min(smallest, pivot);
      largest = s == 0 ? pivot : xsimd::max(largest, pivot);
      eliminate(s, P(T(1)) / pivot);
    }
    substitute_back();
    return smallest > least * largest;
  }

 private:
  /// Swaps the largest diagonal entry from s on into position s.
  void bring_largest(int s) {
#pragma GCC unroll 4
    for (int j = s + 1; j < N; ++j) {
      const Mask larger = at(j, j) > at(s, s);
      swapped_[s][j] = larger;
#pragma GCC unroll 4
      for (int r = 0; r < N; ++r) {
        if (r != s && r != j) swap_where(larger, at(r, s), at(r, j));
      }
      swap_where(larger, at(s, s), at(j, j));
#pragma GCC unroll 4
      for (int k = 0; k < K; ++k) swap_where(larger, right[k][s], right[k][j]);
    }
  }

  void eliminate(int s, const P& inverse) {
    inverse_[s] = inverse;
#pragma GCC unroll 4
    for (int i = s + 1; i < N; ++i) {
      const P factor = at(s, i) * inverse;
#pragma GCC unroll 4
      for (int j = i; j < N; ++j) at(i, j) = fused_minus(factor, at(s, j), at(i, j));
#pragma GCC unroll 4
      for (int k = 0; k < K; ++k) right[k][i] = fused_minus(factor, right[k][s], right[k][i]);
    }
  }

  void substitute_back() {
#pragma GCC unroll 4
    for (int k = 0; k < K; ++k) {
      P(&x)[N] = right[k];
#pragma GCC unroll 4
      for (int s = N - 1; s >= 0; --s) {
#pragma GCC unroll 4
        for (int j = s + 1; j < N; ++j) x[s] = fused_minus(at(s, j), x[j], x[s]);
        x[s] = x[s] * inverse_[s];
      }
#pragma GCC unroll 4
      for (int s = N - 1; s >= 0; --s) {
#pragma GCC unroll 4
        for (int j = N - 1; j > s; --j) swap_where(swapped_[s][j], x[s], x[j]);
      }
    }
  }

  static void swap_where(const Mask& where, P& a, P& b) {
    const P first = xsimd::select(where, b, a);
    b = xsimd::select(where, a, b);
    a = first;
  }

  P matrix_[N][N];  ///< its upper triangle, as (j, i)
  P inverse_[N];    ///< of the pivots
  Mask swapped_[N][N];
};

}  // namespace pliant::kernels
