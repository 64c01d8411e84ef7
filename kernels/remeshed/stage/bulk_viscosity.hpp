#pragma once

#include "kernels/remeshed/stage/chunk.hpp"

/// Bulk viscosity of a reduced polynomial: the pressures p_i of (RP.10) during a stage.
///
/// They are not part of the Runge-Kutta states. Their equations are linear, so (RP.22) advances
/// them from the start of the step to any stage, even if their times are much shorter than the
/// step. Each particle stores them at the start of the step; the last stage overwrites them with
/// the new ones.
namespace pliant::kernels {

/// J - 1 of a register of particles, from F.
template <class P, int D, class Pointer>
inline P volume_change(const std::array<Pointer, material_components<D>>& f, std::int64_t slot) {
  P carried[material_components<D>];
  for (int c = 0; c < material_components<D>; ++c) carried[c] = load<P>(f[c] + slot);
  return determinant(carried) - P(Scalar<P>(1));
}

/// Stores J - 1 at the start of the step, which the third stage overwrites, for later stages.
template <class P, int D>
void keep_volume_changes(const Stage<Scalar<P>, D>& stage, const Chunk& chunk) {
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    volume_change<P, D>(stage.start.material, slot)
        .store_unaligned(stage.viscosity.volume_change + slot);
  }
}

/// Adds sum p_i to the pressure in the diagonal of a stress.
template <class P, int D>
inline void add_pressure(const P& pressure,
                         const std::array<Scalar<P>*, symmetric_components<D>>& stress,
                         std::int64_t slot) {
  for (int i = 0; i < D; ++i) {
    Scalar<P>* diagonal = stress[symmetric_index<D>(i, i)] + slot;
    (load<P>(diagonal) - pressure).store_unaligned(diagonal);
  }
}

/// Adds sum p_i to the stress of the new state, (RP.22).
template <bool last, class P, int D>
void relax_next(const Stage<Scalar<P>, D>& stage, const Chunk& chunk) {
  const BulkViscosity<Scalar<P>>& viscosity = stage.viscosity;
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    const P start = load<P>(viscosity.volume_change + slot);
    const P end = volume_change<P, D>(stage.next.material, slot);
    P sum(Scalar<P>(0));
    for (int i = 0; i < viscosity.terms; ++i) {
      const Relaxation<Scalar<P>>& term = viscosity.relaxation[i];
      Scalar<P>* kept = viscosity.pressure[i] + slot;
      const P driven = fused(P(term.start), start, P(term.end) * end);
      const P p = fused(P(term.decay), load<P>(kept), driven);
      sum = sum + p;
      if constexpr (last) p.store_unaligned(kept);
    }
    add_pressure<P, D>(sum, stage.next_stress, slot);
  }
}

/// Adds the stored p_i of the particles to the stress of a state.
template <class P, int D>
inline void add_kept_pressure(const StressOfState<Scalar<P>, D>& block, std::int64_t slot) {
  P sum(Scalar<P>(0));
  for (int i = 0; i < block.viscosity.terms; ++i) {
    sum = sum + load<P>(block.viscosity.pressure[i] + slot);
  }
  add_pressure<P, D>(sum, block.stress, slot);
}

}  // namespace pliant::kernels
