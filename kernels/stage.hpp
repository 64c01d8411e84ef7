#pragma once

#include "kernels/stage_gradients.hpp"
#include "kernels/stage_update.hpp"
#include "kernels/symmetric_pairs.hpp"

/// One Runge-Kutta stage of one block.
///
/// The memory streams of a stage cost more than its arithmetic. Fusing everything into one loop
/// would open dozens of streams at once; instead a chunk of 64 slots goes through
///
///     sweep over the neighbours -> gradients in a stack buffer (first cache)
///     displacement, velocity, volume, S or F, stress: one short loop each, few streams at a time
///
/// and what one loop has read or written is still in the cache when the next loop wants it.
namespace pliant::kernels {

template <class P, int D>
using GradientsOfChunk = void (*)(const Stage<Scalar<P>, D>&, const Segment<D>&, const Chunk&,
                                  ChunkGradients<Scalar<P>, D>&);

template <class P, int D>
using UpdateOfChunk = void (*)(const Stage<Scalar<P>, D>&, const ChunkGradients<Scalar<P>, D>&,
                               const Chunk&, StageExtremes<P>&);

template <bool listed, class P, int D>
GradientsOfChunk<P, D> gradients_for(Weight weight) {
  switch (weight) {
    case Weight::quartic:
      return stage_gradients<Weight::quartic, listed, P, D>;
    case Weight::quartic_polynomial:
      return stage_gradients<Weight::quartic_polynomial, listed, P, D>;
    case Weight::compact:
      break;
  }
  return stage_gradients<Weight::compact, listed, P, D>;
}

template <bool last, class P, int D>
UpdateOfChunk<P, D> update_for(Model model) {
  switch (model) {
    case Model::linear_rho:
      return stage_update<Model::linear_rho, last, P, D>;
    case Model::linear_log:
      return stage_update<Model::linear_log, last, P, D>;
    case Model::reduced_polynomial:
      break;
  }
  return stage_update<Model::reduced_polynomial, last, P, D>;
}

/// See Stage.
template <class P, int D>
StageResult advance_stage(const Stage<Scalar<P>, D>& stage) {
  const auto gradients_of = stage.pairs != nullptr ? symmetric_gradients<P, D>
                            : stage.neighbours != nullptr
                                ? gradients_for<true, P, D>(stage.weight)
                                : gradients_for<false, P, D>(stage.weight);
  const Model model = stage.material.model;
  const auto update =
      stage.stage == 3 ? update_for<true, P, D>(model) : update_for<false, P, D>(model);
  ChunkGradients<Scalar<P>, D> gradients;
  StageExtremes<P> extremes;
  for (int s = 0; s < stage.segment_count; ++s) {
    const Segment<D>& segment = stage.segments[s];
    for (int begin = 0; begin < segment.count; begin += chunk_slots) {
      const int rest = segment.count - begin;
      const Chunk chunk{segment.first + begin, rest < chunk_slots ? rest : chunk_slots};
      gradients_of(stage, segment, chunk, gradients);
      update(stage, gradients, chunk, extremes);
    }
  }
  return {square_root<P>(largest(extremes.strain_rate2)),
          square_root<P>(largest(extremes.wave_speed2)), extremes.non_finite};
}

}  // namespace pliant::kernels
