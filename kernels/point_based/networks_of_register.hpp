#pragma once

#include <algorithm>

#include "kernels/networks.hpp"
#include "kernels/point_based/arguments.hpp"
#include "kernels/stiffening.hpp"

/// Networks at the nodes of a register, (PB.66).
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

}  // namespace pliant::kernels
