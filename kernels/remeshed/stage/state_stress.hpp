#pragma once

#include "kernels/remeshed/stage/bulk_viscosity.hpp"

namespace pliant::kernels {

/// Stress of one block by one law; returns the largest c^2 of its interior particles.
template <Model model, class P, int D>
Scalar<P> stress_of_block(const StressOfState<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  using L = Law<model, P, D>;
  T* stress[L::symmetric];
#pragma GCC unroll 6
  for (int c = 0; c < L::symmetric; ++c) stress[c] = block.stress[c];
  P largest2(T(0));
  for (int s = 0; s < block.segment_count; ++s) {
    const std::int64_t first = block.segments[s].first;
    for (std::int64_t slot = first; slot < first + block.segments[s].count; slot += lanes<P>) {
      P carried[L::components];
#pragma GCC unroll 9
      for (int c = 0; c < L::components; ++c) carried[c] = load<P>(block.state.material[c] + slot);
      const P density = load<P>(block.mass + slot) / load<P>(block.state.volume + slot);
      const PackState state = block.pack_state[slot / slots_per_pack];
      store_stress<model, P, D>(block.material, carried, density, state, block.interior, slot,
                                stress);
      if (block.viscosity.terms > 0) add_kept_pressure<P, D>(block, slot);
      const P c2 = L::wave_speed2(block.material, carried, density);
      largest2 =
          xsimd::max(largest2, xsimd::select(interior_lanes<P>(block.interior, slot), c2, P(T(0))));
    }
  }
  return largest(largest2);
}

/// See StressOfState. Computes neither the strain rate nor a non-finite slot.
template <class P, int D>
StageResult evaluate_stress(const StressOfState<Scalar<P>, D>& block) {
  const Scalar<P> wave_speed2 = with_model(
      block.material.model, [&]<Model model>() { return stress_of_block<model, P, D>(block); });
  StageResult result;
  result.wave_speed = square_root<P>(wave_speed2);
  return result;
}

}  // namespace pliant::kernels
