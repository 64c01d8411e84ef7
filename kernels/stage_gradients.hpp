#pragma once

#include "kernels/chunk.hpp"
#include "kernels/fourth_difference.hpp"
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

/// What a register of particles contributes to its chunk.
template <class P, int D>
struct StageGradients {
  P velocity[D][D], force[D], drag[D];
};

/// grad u and div sigma from the sums of the sweep, (RP.18), with the dissipation of (RP.43): a
/// drag on the velocity, and a strain rate that relaxes the stress.
template <class P, int D>
[[gnu::always_inline]] inline StageGradients<P, D> gradients_of_register(
    const Stage<Scalar<P>, D>& stage, const StageSweepFields<Scalar<P>, D>& fields,
    const Segment<D>& segment, std::int64_t slot,
    const GradientSums<P, D, D + symmetric_components<D>>& sums) {
  constexpr int symmetric = symmetric_components<D>;
  P gradient[D + symmetric][D], fourth[D + symmetric], relaxation[symmetric];
  solve(sums, gradient);
  fourth_differences<P, D>(fields, segment.neighbour_row.data(), slot, fourth);
  P stress_difference[symmetric];
  for (int c = 0; c < symmetric; ++c) stress_difference[c] = fourth[D + c];
  relaxing_strain_rate<P, D>(stage.material, stage.dissipation, stress_difference, relaxation);
  const P drag(-stage.dissipation);
  StageGradients<P, D> result;
  for (int i = 0; i < D; ++i) {
    result.force[i] = gradient[D + symmetric_index<D>(i, 0)][0];
    for (int j = 1; j < D; ++j) {
      result.force[i] = result.force[i] + gradient[D + symmetric_index<D>(i, j)][j];
    }
    for (int j = 0; j < D; ++j) {
      result.velocity[i][j] = gradient[i][j] + relaxation[symmetric_index<D>(i, j)];
    }
    result.drag[i] = drag * fourth[i];
  }
  return result;
}

/// Into place `at` of the chunk; zero in slots that are not interior.
template <class P, int D>
inline void store_gradients(StageGradients<P, D> gradients, PackState state,
                            const Scalar<P>* interior, std::int64_t slot, int at,
                            ChunkGradients<Scalar<P>, D>& chunk) {
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
          P(T(0)).store_aligned(&chunk.drag[i][at]);
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
      store_gradients<P, D>(gradients_of_register<P, D>(stage, fields, segment, slot, sums), state,
                            stage.interior, slot, at, chunk);
    }
  }
}

}  // namespace pliant::kernels
