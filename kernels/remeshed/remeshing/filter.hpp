#pragma once

#include "kernels/remeshed/remeshing/arguments.hpp"
#include "kernels/remeshed/stage/fourth_difference.hpp"

namespace pliant::kernels {

/// See Filter, (RP.37).
template <class P, int D>
void filter(const Filter<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  const P factor(block.strength / T(16));
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    LineOffsets line[D];
    for (int axis = 0; axis < D; ++axis) {
      line[axis] = line_offsets<typename P::arch_type>(segment, axis);
    }
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += lanes<P>) {
      P value = load<P>(block.field + p);
      // Only near slots inside may neighbours be loaded.
      if (xsimd::any(load<P>(block.inside + p) > P(T(0.5)))) {
        Fluxes<P> fluxes[D];
        for (int axis = 0; axis < D; ++axis) {
          fluxes[axis] = fluxes_within<P>(block.inside + p, line[axis]);
        }
        value = fused_minus(factor, fourth_differences(block.field + p, line, fluxes), value);
      }
      value.store_unaligned(block.filtered + p);
    }
  }
}

}  // namespace pliant::kernels
