#pragma once

#include "kernels/dissipation.hpp"
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

/// Some of the fields of a sweep.
template <int first, int count, class Arch, class T, int D, int F>
inline SweepFields<T, D, count> part_of(const SweepFields<T, D, F>& fields) {
  SweepFields<T, D, count> part;
  for (int i = 0; i < D; ++i) part.displacement[i] = fields.displacement[i];
  for (int f = 0; f < count; ++f) part.field[f] = fields.field[first + f];
  return part;
}

/// What a register of particles contributes to its chunk.
template <class P, int D>
struct StageGradients {
  P velocity[D][D], force[D], drag[D];

  StageGradients() {
    for (P& d : drag) d = P(Scalar<P>(0));
  }
};

/// Gradients of all fields of the sweep, (RP.18). `sweep(fields, sums)` adds up the neighbours.
template <class P, int D, int F, class Sweep>
[[gnu::always_inline]] inline void sweep_gradients(const SweepFields<Scalar<P>, D, F>& fields,
                                                   const Sweep& sweep, P (&gradient)[F][D]) {
  using Arch = typename P::arch_type;
  if constexpr (D == 2) {
    GradientSums<P, D, F> sums;
    sweep(fields, sums);
    solve(sums, gradient);
  } else {
    P inverse[symmetric_components<D>], velocity[D][D], stress[F - D][D];
    {
      GradientSums<P, D, D> sums;
      sweep(part_of<0, D, Arch>(fields), sums);
      invert_symmetric(sums.moment, inverse);
      solve<P, D, D>(inverse, sums, velocity);
    }
    SlopeSums<P, D, F - D> sums;
    sweep(part_of<D, F - D, Arch>(fields), sums);
    solve<P, D, F - D>(inverse, sums, stress);
    for (int f = 0; f < F; ++f) {
      for (int i = 0; i < D; ++i) gradient[f][i] = f < D ? velocity[f][i] : stress[f - D][i];
    }
  }
}

/// grad u and div sigma from the gradients of the sweep.
template <class P, int D>
[[gnu::always_inline]] inline void take_gradients(
    const P (&gradient)[D + symmetric_components<D>][D], StageGradients<P, D>& result) {
  for (int i = 0; i < D; ++i) {
    result.force[i] = gradient[D + symmetric_index<D>(i, 0)][0];
    for (int j = 1; j < D; ++j) {
      result.force[i] = result.force[i] + gradient[D + symmetric_index<D>(i, j)][j];
    }
    for (int j = 0; j < D; ++j) result.velocity[i][j] = gradient[i][j];
  }
}

/// Adds the dissipation of (RP.43): a drag on the velocity, and a strain rate that relaxes the
/// stress, from the fourth differences of both.
template <class P, int D>
[[gnu::always_inline]] inline void dissipate(
    const Stage<Scalar<P>, D>& stage,
    const Scalar<P> (&fourth)[D + symmetric_components<D>][chunk_slots], int at,
    StageGradients<P, D>& result) {
  P difference[symmetric_components<D>], relaxation[symmetric_components<D>];
  for (int c = 0; c < symmetric_components<D>; ++c) {
    difference[c] = P::load_aligned(&fourth[D + c][at]);
  }
  relaxing_strain_rate<P, D>(stage.material, stage.dissipation, difference, relaxation);
  const P drag(-stage.dissipation);
  for (int i = 0; i < D; ++i) {
    result.drag[i] = drag * P::load_aligned(&fourth[i][at]);
    for (int j = 0; j < D; ++j) {
      result.velocity[i][j] = result.velocity[i][j] + relaxation[symmetric_index<D>(i, j)];
    }
  }
}

/// Into place `at` of the chunk; zero in slots that are not interior.
template <class P, int D>
[[gnu::always_inline]] inline void store_gradients(StageGradients<P, D>& gradients, PackState state,
                                                   const Scalar<P>* interior, std::int64_t slot,
                                                   int at, ChunkGradients<Scalar<P>, D>& chunk) {
  if (state != PackState::all) {
    const auto inside = interior_lanes<P>(interior, slot);
    const P zero(Scalar<P>(0));
    for (int i = 0; i < D; ++i) {
      gradients.force[i] = xsimd::select(inside, gradients.force[i], zero);
      gradients.drag[i] = xsimd::select(inside, gradients.drag[i], zero);
      for (int j = 0; j < D; ++j) {
        gradients.velocity[i][j] = xsimd::select(inside, gradients.velocity[i][j], zero);
      }
    }
  }
  for (int i = 0; i < D; ++i) {
    gradients.force[i].store_aligned(&chunk.force[i][at]);
    gradients.drag[i].store_aligned(&chunk.drag[i][at]);
    for (int j = 0; j < D; ++j) gradients.velocity[i][j].store_aligned(&chunk.velocity[i][j][at]);
  }
}

/// The same without interior particles.
template <class P, int D>
inline void store_zeros(int at, ChunkGradients<Scalar<P>, D>& chunk) {
  const P zero(Scalar<P>(0));
  for (int i = 0; i < D; ++i) {
    zero.store_aligned(&chunk.force[i][at]);
    zero.store_aligned(&chunk.drag[i][at]);
    for (int j = 0; j < D; ++j) zero.store_aligned(&chunk.velocity[i][j][at]);
  }
}

/// Gradients of a chunk of a segment, over the stencil or the lists.
template <Weight weight, bool listed, class P, int D>
void stage_gradients(const Stage<Scalar<P>, D>& stage, const Segment<D>& segment,
                     const Chunk& chunk, ChunkGradients<Scalar<P>, D>& gradients) {
  using T = Scalar<P>;
  constexpr int fields_swept = D + symmetric_components<D>;
  const StageSweepFields<T, D> fields = stage_sweep_fields<T, D, typename P::arch_type>(stage);
  alignas(64) T fourth[fields_swept][chunk_slots];
  const bool dissipates = stage.dissipation != 0;
  if (dissipates) {
    fourth_differences<P>(fields, segment, stage.pack_state, stage.interior, chunk, fourth);
  }
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    const PackState state = stage.pack_state[slot / slots_per_pack<T>];
    if (state == PackState::none) {
      store_zeros<P>(at, gradients);
      continue;
    }
    P gradient[fields_swept][D];
    sweep_gradients<P>(
        fields,
        [&](const auto& swept, auto& sums) __attribute__((always_inline)) {
          if constexpr (listed) {
            sweep_list<weight>(swept, *stage.neighbours, slot, stage.spacing, sums);
          } else {
            sweep_stencil<weight>(swept, segment.neighbour_row.data(), slot, stage.spacing, sums);
          }
        },
        gradient);
    StageGradients<P, D> result;
    take_gradients<P, D>(gradient, result);
    if (dissipates) dissipate(stage, fourth, at, result);
    store_gradients(result, state, stage.interior, slot, at, gradients);
  }
}

}  // namespace pliant::kernels
