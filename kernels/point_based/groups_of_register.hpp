#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "kernels/dilatation.hpp"
#include "kernels/point_based/arguments.hpp"
#include "kernels/point_based/kept_gradient.hpp"

/// Groups of adjacent nodes in a pack that share the stiff part of their pressure, (PB.60).
namespace pliant::kernels {

/// Registers that hold whole groups.
template <class P, int D>
inline constexpr int registers_of_groups = std::max(1, slots_per_group<D> / lanes<P>);

/// One value of each node of whole groups.
template <class P, int D>
using OverGroups = P[registers_of_groups<P, D>];

/// The value of the lane whose number differs in the bits of `distance`.
template <int distance, class P, std::size_t... lane>
inline P partner(const P& x, std::index_sequence<lane...>) {
  using Index = xsimd::batch<xsimd::as_unsigned_integer_t<Scalar<P>>, typename P::arch_type>;
  return xsimd::swizzle(x, xsimd::batch_constant<Index, (lane ^ distance)...>());
}

/// In each lane, the sum over the lanes of its group.
template <class P, int D>
inline void add_over_groups(OverGroups<P, D>& x) {
  constexpr auto all = std::make_index_sequence<lanes<P>>();
  for (P& of_register : x) {
    of_register = of_register + partner<1>(of_register, all);
    if constexpr (D == 3 && lanes<P> >= 4) of_register = of_register + partner<2>(of_register, all);
  }
  if constexpr (registers_of_groups<P, D> == 2) x[0] = x[1] = x[0] + x[1];
}

/// The shared modulus times theta_g - theta of the nodes from `slot` on; 0 for nodes without a
/// group. `h` is F - I.
template <ElasticLaw law, class P, int D>
inline void shared_pressure(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                            const P (&h)[registers_of_groups<P, D>][D * D],
                            OverGroups<P, D>& shared) {
  using T = Scalar<P>;
  constexpr int registers = registers_of_groups<P, D>;
  OverGroups<P, D> theta, share, mean;
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    P f[D * D];
    with_unit<P, D>(h[r], f);
    theta[r] = dilatation<law, P, D>(f);
    share[r] = load<P>(block.share + slot + r * lanes<P>);
    mean[r] = share[r] * theta[r];
  }
  add_over_groups<P, D>(mean);
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    const P difference = P(block.shared_modulus) * (mean[r] - theta[r]);
    shared[r] = xsimd::select(share[r] > P(T(0)), difference, P(T(0)));
  }
}

}  // namespace pliant::kernels
