#pragma once

#include <bit>
#include <limits>
#include <utility>

#include "kernels/pack.hpp"
#include "kernels/remeshed/ghosts/arguments.hpp"
#include "kernels/remeshed/ghosts/fit_coefficients.hpp"

namespace pliant::kernels {

/// The register of value(0), value(1), ...
template <class P, class F>
inline P register_of(const F& value) {
  return [&]<int... lane>(std::integer_sequence<int, lane...>) { return P{value(lane)...}; }
  (std::make_integer_sequence<int, lanes<P>>());
}

/// The upper halves of a register of pairs.
template <class P>
inline auto upper_halves(const FitPair* pairs) {
  using Bits = xsimd::as_unsigned_integer_t<P>;
  using Bit = typename Bits::value_type;
  if constexpr (sizeof(Bit) == sizeof(FitPair)) {
    return Bits::load_unaligned(reinterpret_cast<const Bit*>(pairs)) >> 32;
  } else {
    alignas(64) Bit half[lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) half[l] = static_cast<Bit>(pairs[l] >> 32);
    return Bits::load_aligned(half);
  }
}

/// Cells along an axis to the particles of a register of pairs: see cells_along.
template <class P>
inline P cells_of(const FitPair* pairs, int axis) {
  using T = Scalar<P>;
  using Bits = xsimd::as_unsigned_integer_t<P>;
  using Bit = typename Bits::value_type;
  const Bits byte = (upper_halves<P>(pairs) >> (8 * axis)) & Bits(Bit(255));
  // The last place of `large` is 1, so writing a byte to its last bits adds that byte.
  constexpr T large = static_cast<T>(Bit(1) << (std::numeric_limits<T>::digits - 1));
  return xsimd::bitwise_cast<P>(byte | Bits(std::bit_cast<Bit>(large))) - P(large + 128);
}

/// Vectors from a ghost's foot point to the particles of a register of pairs, over h.
template <class P, int D>
inline void find_positions(const FitTerms<Scalar<P>, D>& terms, const FitPair* pairs,
                           P (&position)[D]) {
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) position[a] = cells_of<P>(pairs, a) + P(terms.start[a]);
}

/// Coefficients of a register of pairs of a ghost, starting at `pair`.
template <class P, int D>
inline FitCoefficients<P> coefficients_from(const GhostSums<Scalar<P>, D>& ghosts,
                                            std::int64_t ghost, std::int64_t pair) {
  const FitTerms<Scalar<P>, D>& terms = ghosts.terms[ghost];
  const FitPair* pairs = ghosts.pairs + pair;
  P position[D];
  find_positions(terms, pairs, position);
  const std::int64_t wall = ghosts.wall_begin[ghost];
  const P distance =
      wall < 0 ? register_of<P>([&](int l) { return ghosts.surface_distance[record_of(pairs[l])]; })
               : load<P>(ghosts.wall_distance + wall + (pair - ghosts.begin[ghost]));
  return fit_coefficients(terms, position, distance);
}

/// Pairs whose coefficients are computed together; usually all of a ghost.
inline constexpr int pairs_at_once = 64;

/// Visits the pairs of a ghost in groups: `make(i, pair)` for each register of a group, i counting
/// from 0, then `add(i, record)` for each pair.
template <class P, int D, class Make, class Add>
inline void for_each_pair(const GhostSums<Scalar<P>, D>& ghosts, std::int64_t ghost,
                          const Make& make, const Add& add) {
  const std::int64_t end = ghosts.begin[ghost + 1];
  for (std::int64_t first = ghosts.begin[ghost]; first < end; first += pairs_at_once) {
    const int count = end - first < pairs_at_once ? static_cast<int>(end - first) : pairs_at_once;
    for (int i = 0; i < count; i += lanes<P>) make(i, first + i);
    for (int i = 0; i < count; ++i) {
      add(i, ghosts.records + record_of(ghosts.pairs[first + i]) * std::int64_t{record_width<D>});
    }
  }
}

/// The fits of one ghost. A record fills whole registers, and the three coefficients of a particle
/// are broadcast to them. Sums with b and a cover at least the first `fields` fields. See
/// GhostSums.
template <class P, int D, int fields = record_width<D>>
inline void sum_ghost(const GhostSums<Scalar<P>, D>& ghosts, std::int64_t ghost, Scalar<P>* sums) {
  using T = Scalar<P>;
  constexpr int width = record_width<D>;
  static_assert(width % lanes<P> == 0);
  constexpr int registers = width / lanes<P>, some = (fields + lanes<P> - 1) / lanes<P>;
  P linear[registers], constrained[some], surface[some];
#pragma GCC unroll 8
  for (int r = 0; r < registers; ++r) linear[r] = P(T(0));
#pragma GCC unroll 8
  for (int r = 0; r < some; ++r) constrained[r] = surface[r] = P(T(0));
  alignas(64) T coefficient[3][pairs_at_once];
  const auto make = [&](int i, std::int64_t pair) {
    const FitCoefficients<P> fit = coefficients_from<P, D>(ghosts, ghost, pair);
    fit.linear.store_aligned(coefficient[0] + i);
    fit.constrained.store_aligned(coefficient[1] + i);
    fit.surface.store_aligned(coefficient[2] + i);
  };
  for_each_pair<P, D>(ghosts, ghost, make, [&](int i, const T* record) {
    const P c(coefficient[0][i]), b(coefficient[1][i]), a(coefficient[2][i]);
#pragma GCC unroll 8
    for (int r = 0; r < registers; ++r) {
      const P value = load<P>(record + r * lanes<P>);
      linear[r] = fused(c, value, linear[r]);
      if (r >= some) continue;
      constrained[r] = fused(b, value, constrained[r]);
      surface[r] = fused(a, value, surface[r]);
    }
  });
#pragma GCC unroll 8
  for (int r = 0; r < registers; ++r) linear[r].store_unaligned(sums + r * lanes<P>);
#pragma GCC unroll 8
  for (int r = 0; r < some; ++r) {
    constrained[r].store_unaligned(sums + width + r * lanes<P>);
    surface[r].store_unaligned(sums + 2 * width + r * lanes<P>);
  }
}

template <class P, int D>
void sum_ghosts(const GhostSums<Scalar<P>, D>& ghosts) {
  for (std::int64_t g = 0; g < ghosts.count; ++g) {
    sum_ghost<P, D>(ghosts, ghosts.first + g, ghosts.sums + g * 3 * record_width<D>);
  }
}

/// The same for the velocity only, by (RP.43) or, behind walls, by (RP.44).
template <class P, int D>
void sum_velocities(const GhostSums<Scalar<P>, D>& ghosts) {
  using T = Scalar<P>;
  constexpr int place = RecordPlace<D>::velocity / lanes<P> * lanes<P>;
  constexpr int registers = (RecordPlace<D>::velocity + D - place + lanes<P> - 1) / lanes<P>;
  for (std::int64_t g = 0; g < ghosts.count; ++g) {
    const std::int64_t ghost = ghosts.first + g;
    const FitTerms<T, D>& terms = ghosts.terms[ghost];
    const bool is_behind_wall = ghosts.wall_begin[ghost] >= 0;
    P velocity[registers];
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r) velocity[r] = P(T(0));
    alignas(64) T coefficient[pairs_at_once];
    const auto make = [&](int i, std::int64_t pair) {
      if (is_behind_wall) {
        const FitCoefficients<P> fit = coefficients_from<P, D>(ghosts, ghost, pair);
        return fit.constrained.store_aligned(coefficient + i);
      }
      P position[D];
      find_positions(terms, ghosts.pairs + pair, position);
      (fit_weight(terms, position) * linear_terms(terms.linear, position))
          .store_aligned(coefficient + i);
    };
    for_each_pair<P, D>(ghosts, ghost, make, [&](int i, const T* record) {
      const P c(coefficient[i]);
#pragma GCC unroll 2
      for (int r = 0; r < registers; ++r) {
        velocity[r] = fused(c, load<P>(record + place + r * lanes<P>), velocity[r]);
      }
    });
    T* sums = ghosts.sums + (3 * g + (is_behind_wall ? 1 : 0)) * record_width<D>;
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r) velocity[r].store_unaligned(sums + place + r * lanes<P>);
  }
}

}  // namespace pliant::kernels
