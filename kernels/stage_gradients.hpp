#pragma once

#include "kernels/chunk.hpp"
#include "kernels/gradient_sweep.hpp"

namespace pliant::kernels {

/// Fields of a stage's sweep: velocity, then stress in the order of symmetric_index.
template <class T, int D>
using StageSweepFields = SweepFields<T, D, D + symmetric_components<D>>;

template <class T, int D, class Arch>
inline StageSweepFields<T, D> stage_sweep_fields(const Stage<T, D>& stage) {
  StageSweepFields<T, D> fields;
  for (int i = 0; i < D; ++i) {
    fields.displacement[i] = stage.current.displacement[i];
    fields.field[i] = stage.current.velocity[i];
  }
  for (int c = 0; c < symmetric_components<D>; ++c) fields.field[D + c] = stage.stress[c];
  return fields;
}

/// grad u and div sigma of the register of particles at `slot`, into place `at` of the chunk.
template <class P, int D>
inline void store_gradients(const GradientSums<P, D, D + symmetric_components<D>>& sums,
                            PackState state, const Scalar<P>* interior, std::int64_t slot, int at,
                            ChunkGradients<Scalar<P>, D>& chunk) {
  P gradient[D + symmetric_components<D>][D];
  solve(sums, gradient);
  P force[D];
  for (int i = 0; i < D; ++i) {
    force[i] = gradient[D + symmetric_index<D>(i, 0)][0];
    for (int j = 1; j < D; ++j) force[i] = force[i] + gradient[D + symmetric_index<D>(i, j)][j];
  }
  if (state != PackState::all) {
    const auto inside = interior_lanes<P>(interior, slot);
    const P zero(Scalar<P>(0));
    for (int i = 0; i < D; ++i) {
      force[i] = xsimd::select(inside, force[i], zero);
      for (int j = 0; j < D; ++j) gradient[i][j] = xsimd::select(inside, gradient[i][j], zero);
    }
  }
  for (int i = 0; i < D; ++i) {
    force[i].store_aligned(&chunk.force[i][at]);
    for (int j = 0; j < D; ++j) gradient[i][j].store_aligned(&chunk.velocity[i][j][at]);
  }
}

/// Gradients of `count` slots of a segment from `first` on, over the stencil or the lists.
template <Weight weight, bool listed, class P, int D>
void stage_gradients(const Stage<Scalar<P>, D>& stage, const Segment<D>& segment,
                     std::int64_t first, int count, ChunkGradients<Scalar<P>, D>& chunk) {
  using T = Scalar<P>;
  constexpr int pack = slots_per_pack<T>;
  const StageSweepFields<T, D> fields = stage_sweep_fields<T, D, typename P::arch_type>(stage);
  for (int begin = 0; begin < count; begin += pack) {
    const PackState state = stage.pack_state[(first + begin) / pack];
    for (int at = begin; at < begin + pack; at += lanes<P>) {
      const std::int64_t slot = first + at;
      if (state == PackState::none) {
        for (int i = 0; i < D; ++i) {
          P(T(0)).store_aligned(&chunk.force[i][at]);
          for (int j = 0; j < D; ++j) P(T(0)).store_aligned(&chunk.velocity[i][j][at]);
        }
        continue;
      }
      GradientSums<P, D, D + symmetric_components<D>> sums;
      if constexpr (listed) {
        sweep_list<weight>(fields, *stage.neighbours, slot, stage.spacing, sums);
      } else {
        sweep_stencil<weight>(fields, segment.neighbour_row.data(), slot, stage.spacing, sums);
      }
      store_gradients<P, D>(sums, state, stage.interior, slot, at, chunk);
    }
  }
}

}  // namespace pliant::kernels
