#pragma once

#include "kernels/pack.hpp"
#include "kernels/table.hpp"

namespace pliant::kernels {

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
  for (std::int64_t i = ghosts.begin[ghost]; i < end; ++i) {
    const T* record = ghosts.records + static_cast<std::int64_t>(ghosts.record[i]) * width;
    const P c(ghosts.linear[i]), b(ghosts.constrained[i]), a(ghosts.surface[i]);
#pragma GCC unroll 8
    for (int r = 0; r < registers; ++r) {
      const P value = load<P>(record + r * lanes<P>);
      linear[r] = fused(c, value, linear[r]);
      constrained[r] = fused(b, value, constrained[r]);
      surface[r] = fused(a, value, surface[r]);
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
    P velocity[registers];
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r) velocity[r] = P(T(0));
    const std::int64_t end = ghosts.begin[ghosts.first + g + 1];
    for (std::int64_t i = ghosts.begin[ghosts.first + g]; i < end; ++i) {
      const T* record = ghosts.records + static_cast<std::int64_t>(ghosts.record[i]) * width;
      const P c(ghosts.linear[i]);
#pragma GCC unroll 2
      for (int r = 0; r < registers; ++r) {
        velocity[r] = fused(c, load<P>(record + r * lanes<P>), velocity[r]);
      }
    }
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r) {
      velocity[r].store_unaligned(ghosts.sums + g * 3 * width + r * lanes<P>);
    }
  }
}

}  // namespace pliant::kernels
