#pragma once

#include "kernels/total_lagrangian/corner_modes.hpp"

namespace pliant::kernels {

/// Adds a register's lanes to a sum, first to last.
template <class P>
inline void add_lanes(const P& pack, double& sum) {
  alignas(64) Scalar<P> lane[lanes<P>];
  pack.store_aligned(lane);
  for (int l = 0; l < lanes<P>; ++l) sum += lane[l];
}

/// See Motion. Lanes of eight whatever the register, so that the sums are those of any instruction
/// set with fused multiply-add.
template <class P, int D>
MotionResult advance_motion(const Motion<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  constexpr int rows = 1 << (D - 1), registers = registers_per_pack<P>;
  const P zero(T(0));
  P stiffness[registers], inertia[registers];
#pragma GCC unroll 4
  for (int k = 0; k < registers; ++k) stiffness[k] = inertia[k] = zero;
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    std::int64_t row[rows];
#pragma GCC unroll 4
    for (int r = 0; r < rows; ++r) row[r] = corner_row<typename P::arch_type>(segment, r, -1);
    for (std::int64_t slot = segment.first; slot < segment.first + segment.count;
         slot += lanes<P>) {
      const P inverse_mass = load<P>(block.inverse_mass + slot);
      const auto inside = inverse_mass > zero;
      if (!xsimd::any(inside)) continue;
      const int k = static_cast<int>(slot % slots_per_pack) / lanes<P>;
      const P mass = xsimd::select(inside, P(T(1)) / inverse_mass, zero);
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
        P force = zero;
#pragma GCC unroll 7
        for (int m = 1; m <= cell_modes<D>; ++m) {
          force = force - force_of_mode<P, D>(block.force[i][m - 1], row, slot, m);
        }
        force = xsimd::select(inside, force, zero);
        const P before = load<P>(block.internal[i] + slot);
        const P u = load<P>(block.velocity[i] + slot);
        stiffness[k] = fused(u, before - force, stiffness[k]);
        inertia[k] = fused(u * u, mass, inertia[k]);
        force.store_unaligned(block.internal[i] + slot);
        const P pull = force + load<P>(block.traction[i] + slot);
        const P next = fused(P(block.gained) * inverse_mass, pull, P(block.kept) * u);
        next.store_unaligned(block.velocity[i] + slot);
        fused(P(block.time_step), next, load<P>(block.displacement[i] + slot))
            .store_unaligned(block.displacement[i] + slot);
      }
    }
  }
  MotionResult result;
#pragma GCC unroll 4
  for (int k = 0; k < registers; ++k) {
    add_lanes(stiffness[k], result.stiffness);
    add_lanes(inertia[k], result.inertia);
  }
  return result;
}

}  // namespace pliant::kernels
