#pragma once

#include "kernels/remeshed/stage/dissipation.hpp"
#include "kernels/remeshed/stage/gradient_sweep.hpp"
#include "kernels/remeshed/stage/prefetch.hpp"

namespace pliant::kernels {

/// Fields of a stage's sweep: velocity, then stress in the order of symmetric_index.
template <class T, int D>
using StageSweepFields = SweepFields<T, D, D + symmetric_components<D>>;

template <class T, int D, class Arch>
inline StageSweepFields<T, D> stage_sweep_fields(const Stage<T, D>& stage) {
  StageSweepFields<T, D> fields;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    fields.drift[i] = stage.current.drift[i];
    fields.field[i] = stage.current.velocity[i];
  }
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) fields.field[D + c] = stage.stress[c];
  return fields;
}

/// Gradients of a register of particles, for its chunk.
template <class P, int D>
struct StageGradients {
  P velocity[D][D], force[D], drag[D];

  StageGradients() {
    for (P& d : drag) d = P(Scalar<P>(0));
  }
};

/// grad u and div sigma in 2D, in one sweep; `visit(f)` visits the neighbours.
template <Kernel kernel, Gradient gradient, class P, class Visit>
[[gnu::always_inline]] inline void sweep(const StageSweepFields<Scalar<P>, 2>& fields,
                                         const Scalar<P>* volume, std::int64_t slot,
                                         Scalar<P> spacing, bool, const Visit& visit,
                                         StageGradients<P, 2>& result) {
  constexpr int D = 2, F = D + symmetric_components<D>;
  const Separation<kernel, P, D> separation(fields.drift, slot, spacing);
  const VolumeWeight<gradient, P, D> times_volume(volume);
  const Differences<P, F> differences(fields.field, slot);
  GradientSums<P, D, F> sums;
  visit([&](const P(&offset)[D], const auto& neighbour) __attribute__((always_inline)) {
    P d[D], weighted[D], difference[F];
    separation(offset, neighbour, d, weighted);
    times_volume(neighbour, weighted);
    differences(neighbour, difference);
    sums.add(weighted, d, difference);
  });
  P slope[F][D];
  solve<gradient>(sums, slope);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    result.force[i] = slope[D + symmetric_index<D>(i, 0)][0];
#pragma GCC unroll 3
    for (int j = 1; j < D; ++j) {
      result.force[i] = result.force[i] + slope[D + symmetric_index<D>(i, j)][j];
    }
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) result.velocity[i][j] = slope[i][j];
  }
}

/// The same in 3D, in two sweeps; see gradient_sweep.hpp. The weights of a stencil are stored for
/// the second sweep. Those of a list, which may have any length, are computed again.
template <Kernel kernel, Gradient gradient, class P, class Visit>
[[gnu::always_inline]] inline void sweep(const StageSweepFields<Scalar<P>, 3>& fields,
                                         const Scalar<P>* volume, std::int64_t slot,
                                         Scalar<P> spacing, bool listed, const Visit& visit,
                                         StageGradients<P, 3>& result) {
  constexpr int D = 3, F = symmetric_components<D>;
  using T = Scalar<P>;
  const Separation<kernel, P, D> separation(fields.drift, slot, spacing);
  const VolumeWeight<gradient, P, D> times_volume(volume);
  alignas(64) T kept[stencil_bound<kernel, D>][D][lanes<P>];
  P inverse[symmetric_components<D>];
  {
    const Differences<P, D> differences(fields.field, slot);
    GradientSums<P, D, D> sums;
    int pair = 0;
    visit([&](const P(&offset)[D], const auto& neighbour) __attribute__((always_inline)) {
      P d[D], weighted[D], difference[D];
      separation(offset, neighbour, d, weighted);
      times_volume(neighbour, weighted);
      if (!listed) {
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i) weighted[i].store_aligned(kept[pair][i]);
        ++pair;
      }
      differences(neighbour, difference);
      sums.add(weighted, d, difference);
    });
    invert_moment<gradient>(sums.moment, inverse);
    solve<P, D, D>(inverse, sums, result.velocity);
  }
  const Differences<P, F> differences(fields.field + D, slot);
  for (P& f : result.force) f = P(T(0));
  int pair = 0;
  visit([&](const P(&offset)[D], const auto& neighbour) __attribute__((always_inline)) {
    P weighted[D], difference[F];
    if (listed) {
      P d[D];
      separation(offset, neighbour, d, weighted);
      times_volume(neighbour, weighted);
    } else {
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) weighted[i] = P::load_aligned(kept[pair][i]);
      ++pair;
    }
    differences(neighbour, difference);
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      P share = inverse[symmetric_index<D>(j, 0)] * weighted[0];
#pragma GCC unroll 3
      for (int k = 1; k < D; ++k) {
        share = fused(inverse[symmetric_index<D>(j, k)], weighted[k], share);
      }
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
        result.force[i] = fused(share, difference[symmetric_index<D>(i, j)], result.force[i]);
      }
    }
  });
}

/// Differences of a chunk: of velocity and stress, in the order of the sweep, and Delta xi.
template <class P, int D>
struct ChunkDifferences {
  alignas(64) Scalar<P> swept[D + symmetric_components<D>][chunk_slots];
  alignas(64) Scalar<P> place[D][chunk_slots];
};

/// Adds the dissipation of (RP.23): a drag on the velocity, which may include a force that restores
/// places on the lattice, and a strain rate that relaxes the stress.
template <class P, int D>
[[gnu::always_inline]] inline void dissipate(const Stage<Scalar<P>, D>& stage,
                                             const ChunkDifferences<P, D>& damped, int at,
                                             StageGradients<P, D>& result) {
  P difference[symmetric_components<D>], relaxation[symmetric_components<D>];
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) {
    difference[c] = takes_differences<typename P::arch_type, D>(D + c)
                        ? P::load_aligned(&damped.swept[D + c][at])
                        : P(Scalar<P>(0));
  }
  relaxing_strain_rate<P, D>(stage.material, stage.stress_dissipation,
                             D == 2 && stage.relaxes_shear, difference, relaxation);
  const P drag(-stage.velocity_dissipation), restoring(stage.restoring_rate);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    P rate = P::load_aligned(&damped.swept[i][at]);
    if (stage.restoring_rate != 0) {
      rate = fused(restoring, P::load_aligned(&damped.place[i][at]), rate);
    }
    result.drag[i] = drag * rate;
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) {
      result.velocity[i][j] = result.velocity[i][j] + relaxation[symmetric_index<D>(i, j)];
    }
  }
}

/// Stores gradients at position `at` of the chunk; zero in slots that are not interior.
template <class P, int D>
[[gnu::always_inline]] inline void store_gradients(StageGradients<P, D>& gradients, PackState state,
                                                   const Mark* interior, std::int64_t slot, int at,
                                                   ChunkGradients<Scalar<P>, D>& chunk) {
  if (state != PackState::all) {
    const auto inside = interior_lanes<P>(interior, slot);
    const P zero(Scalar<P>(0));
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      gradients.force[i] = xsimd::select(inside, gradients.force[i], zero);
      gradients.drag[i] = xsimd::select(inside, gradients.drag[i], zero);
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) {
        gradients.velocity[i][j] = xsimd::select(inside, gradients.velocity[i][j], zero);
      }
    }
  }
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    gradients.force[i].store_aligned(&chunk.force[i][at]);
    gradients.drag[i].store_aligned(&chunk.drag[i][at]);
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) gradients.velocity[i][j].store_aligned(&chunk.velocity[i][j][at]);
  }
}

/// Gradients of a chunk of a segment, over the stencil or the lists.
template <Kernel kernel, Gradient gradient, bool listed, class P, int D>
void stage_gradients(const Stage<Scalar<P>, D>& stage, const Segment<D>& segment,
                     const Chunk& chunk, ChunkGradients<Scalar<P>, D>& gradients) {
  using T = Scalar<P>;
  const StageSweepFields<T, D> fields = stage_sweep_fields<T, D, typename P::arch_type>(stage);
  ChunkDifferences<P, D> damped;
  const bool dissipates = stage.velocity_dissipation != 0 || stage.stress_dissipation != 0;
  if (dissipates) {
    swept_differences<P>(fields.field, segment, stage.interior, chunk, damped.swept);
    if (stage.restoring_rate != 0) {
      place_differences<P>(fields.drift, segment, stage.interior, chunk, damped.place);
    }
  }
  for (int at = 0; at < chunk.count; at += lanes<P>) {
    const std::int64_t slot = chunk.first + at;
    const PackState state = stage.pack_state[slot / slots_per_pack];
    if (at % slots_per_pack == 0) prefetch_update<P>(stage, slot);
    StageGradients<P, D> result;
    sweep<kernel, gradient, P>(
        fields, stage.current.volume, slot, stage.spacing, listed,
        [&](const auto& visit) __attribute__((always_inline)) {
          if constexpr (listed) {
            visit_list<P, D>(*stage.neighbours, slot, visit);
          } else {
            visit_stencil<kernel, P, D>(segment.neighbour_row.data(), slot, visit);
          }
        },
        result);
    if (dissipates) dissipate(stage, damped, at, result);
    store_gradients(result, state, stage.interior, slot, at, gradients);
  }
}

}  // namespace pliant::kernels
