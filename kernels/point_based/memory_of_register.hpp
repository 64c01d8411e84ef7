#pragma once

#include <algorithm>

#include "kernels/networks.hpp"
#include "kernels/point_based/arguments.hpp"
#include "kernels/point_based/groups_of_register.hpp"
#include "kernels/point_based/kept_gradient.hpp"
#include "kernels/stiffening.hpp"

/// What the nodes of a register remember: networks, (PB.66), and relaxing pressures, (PB.70).
namespace pliant::kernels {

/// The values of the nodes of a register, from `slot` on.
template <class P>
struct NodeSlots {
  using T = Scalar<P>;
  std::int64_t slot;

  P get(const T* from) const { return load<P>(from + slot); }
  void put(T* to, const P& value, const P&) const { value.store_unaligned(to + slot); }
};

/// The same for states that must stay as they are.
template <class P>
struct FixedNodeSlots : NodeSlots<P> {
  void put(Scalar<P>*, const P&, const P&) const {}
};

template <class P, int D>
inline Deformation<P, D> deformation(const P (&f)[D * D]) {
  Deformation<P, D> state;
  std::copy_n(f, D * D, state.f);
  state.find_cofactor();
  return state;
}

/// Advances the networks of the nodes from `slot` on, (TL.24), and adds their stress.
template <class P, int D>
[[gnu::noinline]] void add_networks(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                                    const P (&f)[D * D], P (&piola)[D * D]) {
  const Deformation<P, D> state = deformation<P, D>(f);
  relax_networks<P, D>(block.networks, block.material.polynomial, false, state, NodeSlots<P>{slot},
                       piola);
}

/// What the networks add to rho0 c_X^2 of (PB.12).
template <class P, int D>
inline P network_modulus(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                         const P (&f)[D * D]) {
  const Deformation<P, D> state = deformation<P, D>(f);
  P unused[D * D];
  for (P& component : unused) component = P(Scalar<P>(0));
  const P speed2 = relax_networks<P, D>(block.networks, block.material.polynomial, true, state,
                                        FixedNodeSlots<P>{{slot}}, unused);
  return P(block.material.density) * speed2 * norm2_of<P, D>(state.cof) /
         (state.volume_ratio * state.volume_ratio);
}

/// Adds the relaxing pressures to the stiff part of groups, `shared`, of the nodes from `slot` on,
/// (PB.70). `h` is F - I.
template <class P, int D>
[[gnu::noinline]] void relax_nodes(const PointForces<Scalar<P>, D>& block, std::int64_t slot,
                                   const P (&h)[registers_of_groups<P, D>][D * D],
                                   OverGroups<P, D>& shared) {
  using T = Scalar<P>;
  constexpr int registers = registers_of_groups<P, D>;
  OverGroups<P, D> theta, share, mean;
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    const std::int64_t first = slot + r * lanes<P>;
    P f[D * D];
    with_unit<P, D>(h[r], f);
    if (block.kept[0] != nullptr) {
      P kept[D * D];
      apply_kept<P, D>(block, first, f, kept);
    }
    theta[r] = determinant(f) - P(T(1));
    share[r] = block.share != nullptr ? load<P>(block.share + first) : P(T(0));
    mean[r] = share[r] * theta[r];
  }
  add_over_groups<P, D>(mean);
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) {
    const P change = xsimd::select(share[r] > P(T(0)), mean[r], theta[r]);
    const NodeSlots<P> nodes = {slot + r * lanes<P>};
    shared[r] = shared[r] - relax_pressures<P>(block.bulk, change, nodes);
  }
}

}  // namespace pliant::kernels
