#pragma once

#include "kernels/pack.hpp"
#include "kernels/point_based/point_lanes.hpp"

namespace pliant::kernels {

template <class P, int D>
void advance_points(const PointMotion<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  for (int c = 0; c < block.collected_count; ++c) {
    const CollectedForces<T>& from = block.collected[c];
    for (int i = 0; i < from.count; ++i) {
      T* to = block.force + point_stride * (from.slot[i] - block.first);
      T sum[point_stride];  // lets the compiler add all components at once
      for (int a = 0; a < point_stride; ++a) sum[a] = to[a] + from.force[point_stride * i + a];
      for (int a = 0; a < point_stride; ++a) to[a] = sum[a];
    }
  }
  std::uint16_t place[lanes<P>];
  for (int l = 0; l < lanes<P>; ++l) place[l] = static_cast<std::uint16_t>(point_stride * l);
  for (int local = 0; local < block.count; local += lanes<P>) {
    const std::int64_t slot = block.first + local;
    P force[D];
    PointLanes<P, D>::gather(block.force + point_stride * local, place, force);
    const P inverse_mass = load<P>(block.inverse_mass + slot);
    const auto exists = inverse_mass > P(T(0));
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      if (block.external[a] != nullptr) force[a] = force[a] + load<P>(block.external[a] + slot);
      const P pull =
          xsimd::select(exists, fused(force[a], inverse_mass, P(block.gravity[a])), P(T(0)));
      const P u = load<P>(block.velocity[a] + slot);
      const P next = fused(P(block.gained), pull, P(block.kept) * u);
      next.store_unaligned(block.velocity[a] + slot);
      fused(P(block.drift), next, load<P>(block.displacement[a] + slot))
          .store_unaligned(block.displacement[a] + slot);
    }
  }
}

template <class P, int D>
void drift_points(const PointDrift<Scalar<P>, D>& block) {
  for (int a = 0; a < D; ++a) {
    for (std::int64_t slot = block.first; slot < block.first + block.count; slot += lanes<P>) {
      fused(P(block.drift), load<P>(block.velocity[a] + slot),
            load<P>(block.displacement[a] + slot))
          .store_unaligned(block.displacement[a] + slot);
    }
  }
}

}  // namespace pliant::kernels
