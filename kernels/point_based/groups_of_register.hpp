#pragma once

#include <algorithm>

#include "kernels/dilatation.hpp"
#include "kernels/point_based/arguments.hpp"

/// Groups of adjacent nodes in a pack that share the stiff part of their pressure, (PB.60).
namespace pliant::kernels {

/// Registers that hold whole groups.
template <class P, int D>
inline constexpr int registers_of_groups = std::max(1, slots_per_group<D> / lanes<P>);

/// (lambda - 3/2 mu) (theta_g - theta) of the nodes from `slot` on; 0 for nodes without a group.
/// `h` is F - I.
template <ElasticLaw law, class P, int D>
inline void shared_pressure(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                            const P (&h)[registers_of_groups<P, D>][D * D],
                            P (&shared)[registers_of_groups<P, D>]) {
  using T = Scalar<P>;
  constexpr int registers = registers_of_groups<P, D>, count = registers * lanes<P>;
  alignas(64) T theta[count];
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    P f[D * D];
#pragma GCC unroll 9
    for (int c = 0; c < D * D; ++c) f[c] = c % (D + 1) == 0 ? h[r][c] + P(T(1)) : h[r][c];
    dilatation<law, P, D>(f).store_aligned(theta + r * lanes<P>);
  }
  const T* const share = block.share + slot;
  for (int first = 0; first < count; first += slots_per_group<D>) {
    T mean = 0;
    for (int l = first; l < first + slots_per_group<D>; ++l) mean += share[l] * theta[l];
    for (int l = first; l < first + slots_per_group<D>; ++l) {
      theta[l] = share[l] > 0 ? block.shared_modulus * (mean - theta[l]) : T(0);
    }
  }
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) shared[r] = P::load_aligned(theta + r * lanes<P>);
}

}  // namespace pliant::kernels
