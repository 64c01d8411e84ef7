#pragma once

#include "kernels/fit_coefficients.hpp"
#include "kernels/pack.hpp"
#include "kernels/table.hpp"

namespace pliant::kernels {

/// The register of value(0), value(1), ...
template <class P, class F>
inline P register_of(const F& value) {
  alignas(64) Scalar<P> lane[lanes<P>];
  for (int l = 0; l < lanes<P>; ++l) lane[l] = value(l);
  return P::load_aligned(lane);
}

/// From a ghost's foot point to the particles of a register of pairs, over h.
template <class P, int D>
inline void find_positions(const FitTerms<Scalar<P>, D>& terms, const FitPair* pairs,
                           P (&position)[D]) {
  using T = Scalar<P>;
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) {
    position[a] = register_of<P>([&](int l) { return static_cast<T>(cells_along(pairs[l], a)); }) +
                  P(terms.start[a]);
  }
}

/// Coefficients of a register of pairs of a ghost, those from `pair` on.
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

/// Pairs whose coefficients are made at a time: mostly those of a whole ghost.
inline constexpr int pairs_at_once = 64;

/// The fits of all fields of one ghost at once: a record fills whole registers, and the three
/// coefficients of a particle are broadcast to them. See GhostSums.
template <class P, int D>
inline void sum_ghost(const GhostSums<Scalar<P>, D>& ghosts, std::int64_t ghost, Scalar<P>* sums) {
  using T = Scalar<P>;
  constexpr int width = record_width<D>;
  // Float registers may be longer than the record is wide: then each is summed in whole lanes only.
  static_assert(width % lanes<P> == 0);
  constexpr int registers = width / lanes<P>;
  P linear[registers], constrained[registers], surface[registers];
#pragma GCC unroll 8
  for (int r = 0; r < registers; ++r) linear[r] = constrained[r] = surface[r] = P(T(0));
  const std::int64_t end = ghosts.begin[ghost + 1];
  alignas(64) T coefficient[3][pairs_at_once];
  for (std::int64_t first = ghosts.begin[ghost]; first < end; first += pairs_at_once) {
    const int count = end - first < pairs_at_once ? static_cast<int>(end - first) : pairs_at_once;
    for (int i = 0; i < count; i += lanes<P>) {
      const FitCoefficients<P> fit = coefficients_from<P, D>(ghosts, ghost, first + i);
      fit.linear.store_aligned(coefficient[0] + i);
      fit.constrained.store_aligned(coefficient[1] + i);
      fit.surface.store_aligned(coefficient[2] + i);
    }
    for (int i = 0; i < count; ++i) {
      const T* record = ghosts.records + record_of(ghosts.pairs[first + i]) * std::int64_t{width};
      const P c(coefficient[0][i]), b(coefficient[1][i]), a(coefficient[2][i]);
#pragma GCC unroll 8
      for (int r = 0; r < registers; ++r) {
        const P value = load<P>(record + r * lanes<P>);
        linear[r] = fused(c, value, linear[r]);
        constrained[r] = fused(b, value, constrained[r]);
        surface[r] = fused(a, value, surface[r]);
      }
    }
  }
#pragma GCC unroll 8
  for (int r = 0; r < registers; ++r) {
    linear[r].store_unaligned(sums + r * lanes<P>);
    constrained[r].store_unaligned(sums + width + r * lanes<P>);
    surface[r].store_unaligned(sums + 2 * width + r * lanes<P>);
  }
}

/// See GhostSums.
template <class P, int D>
void sum_ghosts(const GhostSums<Scalar<P>, D>& ghosts) {
  for (std::int64_t g = 0; g < ghosts.count; ++g) {
    sum_ghost<P, D>(ghosts, ghosts.first + g, ghosts.sums + g * 3 * record_width<D>);
  }
}

/// The same of the velocity alone, by (RP.32).
template <class P, int D>
void sum_velocities(const GhostSums<Scalar<P>, D>& ghosts) {
  using T = Scalar<P>;
  constexpr int width = record_width<D>;
  constexpr int registers = (D + lanes<P> - 1) / lanes<P>;
  for (std::int64_t g = 0; g < ghosts.count; ++g) {
    const FitTerms<T, D>& terms = ghosts.terms[ghosts.first + g];
    P velocity[registers];
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r) velocity[r] = P(T(0));
    const std::int64_t end = ghosts.begin[ghosts.first + g + 1];
    alignas(64) T coefficient[pairs_at_once];
    for (std::int64_t first = ghosts.begin[ghosts.first + g]; first < end; first += pairs_at_once) {
      const int count = end - first < pairs_at_once ? static_cast<int>(end - first) : pairs_at_once;
      for (int i = 0; i < count; i += lanes<P>) {
        P position[D];
        find_positions(terms, ghosts.pairs + first + i, position);
        (fit_weight(terms, position) * linear_terms(terms.linear, position))
            .store_aligned(coefficient + i);
      }
      for (int i = 0; i < count; ++i) {
        const T* record = ghosts.records + record_of(ghosts.pairs[first + i]) * std::int64_t{width};
        const P c(coefficient[i]);
#pragma GCC unroll 2
        for (int r = 0; r < registers; ++r) {
          velocity[r] = fused(c, load<P>(record + r * lanes<P>), velocity[r]);
        }
      }
    }
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r) {
      velocity[r].store_unaligned(ghosts.sums + g * 3 * width + r * lanes<P>);
    }
  }
}

}  // namespace pliant::kernels
