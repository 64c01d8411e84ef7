#pragma once

#include "kernels/pack.hpp"
#include "kernels/remeshed/stage/arguments.hpp"

/// Prefetches of cache lines. A stage reads and writes more than fifty streams in short bursts,
/// more than the processor can prefetch by itself.
namespace pliant::kernels {

/// Prefetches the line at `slot` of every evolving field except the drift; `components` of the
/// material state.
template <class P, class T, int D>
[[gnu::always_inline]] inline void prefetch(const Evolving<T, D>& state, int components,
                                            std::int64_t slot) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) __builtin_prefetch(state.velocity[i] + slot);
  __builtin_prefetch(state.volume + slot);
  for (int c = 0; c < components; ++c) __builtin_prefetch(state.material[c] + slot);
}

/// Prefetches what the update of the pack at `slot` reads and writes.
template <class P, int D>
[[gnu::always_inline]] inline void prefetch_update(const Stage<Scalar<P>, D>& stage,
                                                   std::int64_t slot) {
  const int components = material_component_count<D>(stage.material.model);
  prefetch<P>(stage.start, components, slot);
  prefetch<P>(stage.next, components, slot);
  if (stage.stage == 2) prefetch<P>(stage.second, components, slot);
  if (stage.stage == 3) prefetch<P>(stage.third, components, slot);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    __builtin_prefetch(stage.start.drift[i] + slot);
    __builtin_prefetch(stage.next.drift[i] + slot);
  }
  __builtin_prefetch(stage.mass + slot);
  __builtin_prefetch(stage.current.volume + slot);
  for (int c = 0; c < components; ++c) __builtin_prefetch(stage.current.material[c] + slot);
#pragma GCC unroll 6
  for (int c = 0; c < symmetric_components<D>; ++c) {
    __builtin_prefetch(stage.next_stress[c] + slot);
  }
}

/// Prefetches fields two packs ahead, in a row that no earlier slot has loaded.
template <class P, int F>
[[gnu::always_inline]] inline void prefetch_ahead(const Scalar<P>* const (&field)[F],
                                                  std::int64_t slot) {
#pragma GCC unroll 9
  for (int f = 0; f < F; ++f) {
    __builtin_prefetch(field[f] + slot + 2 * slots_per_pack);
  }
}

}  // namespace pliant::kernels
