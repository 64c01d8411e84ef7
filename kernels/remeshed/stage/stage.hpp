#pragma once

#include "kernels/remeshed/stage/lattice_gradient.hpp"
#include "kernels/remeshed/stage/stage_gradients.hpp"
#include "kernels/remeshed/stage/stage_update.hpp"
#include "kernels/remeshed/stage/symmetric_pairs.hpp"

/// One Runge-Kutta stage of one block.
///
/// The memory streams of a stage cost more than its arithmetic. A single loop would need dozens of
/// streams at once. Instead a chunk of 64 slots goes through several loops,
///
///     sweep over the neighbours -> gradients in a stack buffer (first cache)
///     drift, velocity, volume, S or F, stress: one short loop each, few streams at a time
///
/// and what one loop has read or written is still in the cache for the next one. Packs of ghosts
/// only drift, and vacant packs are skipped.
namespace pliant::kernels {

template <class P, int D>
using GradientsOfChunk = void (*)(const Stage<Scalar<P>, D>&, const Segment<D>&, const Chunk&,
                                  ChunkGradients<Scalar<P>, D>&);

template <class P, int D>
using UpdateOfChunk = void (*)(const Stage<Scalar<P>, D>&, const ChunkGradients<Scalar<P>, D>&,
                               const Chunk&, StageExtremes<P>&);

template <bool listed, class P, int D>
GradientsOfChunk<P, D> gradients_for(Kernel kernel, Gradient gradient) {
  constexpr Gradient exact = Gradient::moment_matrix;
  if (gradient == Gradient::normalised) {
    return stage_gradients<Kernel::quartic_spline, Gradient::normalised, listed, P, D>;
  }
  switch (kernel) {
    case Kernel::quartic_spline:
      return stage_gradients<Kernel::quartic_spline, exact, listed, P, D>;
    case Kernel::quartic_spline_fit:
      return stage_gradients<Kernel::quartic_spline_fit, exact, listed, P, D>;
    case Kernel::compact:
      return stage_gradients<Kernel::compact, exact, listed, P, D>;
    case Kernel::fourth_order:
      break;
  }
  // The moments of fourth_order vanish only on the lattice.
  constexpr Kernel present = listed ? Kernel::quartic_spline_fit : Kernel::fourth_order;
  return stage_gradients<present, exact, listed, P, D>;
}

template <StagePlace place, class P, int D>
UpdateOfChunk<P, D> update_for(Model model) {
  return with_model(model, []<Model constant>() -> UpdateOfChunk<P, D> {
    return stage_update<constant, place, P, D>;
  });
}

enum class Slots { vacant, ghosts, particles };

template <class P, int D>
Slots slots_at(const Stage<Scalar<P>, D>& stage, std::int64_t slot) {
  const PackState state = stage.pack_state[slot / slots_per_pack];
  return holds_interior(state)        ? Slots::particles
         : state == PackState::ghosts ? Slots::ghosts
                                      : Slots::vacant;
}

/// The next slots of a segment, from `begin` on, whose packs are of one kind; at most a chunk.
template <class P, int D>
Chunk next_chunk(const Stage<Scalar<P>, D>& stage, const Segment<D>& segment, int begin) {
  constexpr int pack = slots_per_pack;
  Chunk chunk{segment.first + begin, pack};
  const Slots kind = slots_at<P>(stage, chunk.first);
  while (begin + chunk.count < segment.count && chunk.count < chunk_slots &&
         slots_at<P>(stage, chunk.first + chunk.count) == kind) {
    chunk.count += pack;
  }
  return chunk;
}

/// One stage; see Stage.
template <StagePlace place, class P, int D>
StageResult advance_stage_at(const Stage<Scalar<P>, D>& stage) {
  const auto gradients_of = stage.pairs != nullptr ? symmetric_gradients<P, D>
                            : stage.neighbours != nullptr
                                ? gradients_for<true, P, D>(stage.kernel, stage.gradient)
                                : gradients_for<false, P, D>(stage.kernel, stage.gradient);
  const auto update = update_for<place, P, D>(stage.material.model);
  ChunkGradients<Scalar<P>, D> gradients;
  StageExtremes<P> extremes;
  for (int s = 0; s < stage.segment_count; ++s) {
    const Segment<D>& segment = stage.segments[s];
    for (int begin = 0; begin < segment.count;) {
      const Chunk chunk = next_chunk<P>(stage, segment, begin);
      begin += chunk.count;
      switch (slots_at<P>(stage, chunk.first)) {
        case Slots::vacant:
          break;
        case Slots::ghosts:
          advance_drifts<P, place, false>(stage, chunk);
          break;
        case Slots::particles:
          gradients_of(stage, segment, chunk, gradients);
          update(stage, gradients, chunk, extremes);
          if (place == StagePlace::last && stage.pairs == nullptr) {
            extremes.deformation2 = largest_gradient2<P, D>(stage.current.drift, stage.interior,
                                                            segment, chunk, extremes.deformation2);
          }
      }
    }
  }
  return {square_root<P>(largest(extremes.strain_rate2)),
          square_root<P>(largest(extremes.deformation2)) / stage.spacing,
          square_root<P>(largest(extremes.wave_speed2)), extremes.non_finite};
}

template <class P, int D>
StageResult advance_stage(const Stage<Scalar<P>, D>& stage) {
  switch (stage.stage) {
    case 2:
      return advance_stage_at<StagePlace::third, P, D>(stage);
    case 3:
      return advance_stage_at<StagePlace::last, P, D>(stage);
  }
  return advance_stage_at<StagePlace::early, P, D>(stage);
}

}  // namespace pliant::kernels
