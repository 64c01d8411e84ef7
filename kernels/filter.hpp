#pragma once

#include "kernels/fourth_difference.hpp"
#include "kernels/table.hpp"

namespace pliant::kernels {

/// Lanes whose slot and the two to each side along a line are valid.
template <class P>
inline auto valid_lanes(const Scalar<P>* centre, const LineOffsets& line) {
  P all_valid = load<P>(centre);
  for (const std::int64_t away : line.away) all_valid = all_valid * load<P>(centre + away);
  return all_valid > P(Scalar<P>(0.5));
}

/// See Filter, (RP.27).
template <class P, int D>
void filter(const Filter<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  const P factor(block.strength / T(16)), zero(T(0));
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    LineOffsets line[D];
    for (int axis = 0; axis < D; ++axis) {
      line[axis] = line_offsets<typename P::arch_type>(segment, axis);
    }
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += lanes<P>) {
      P value = load<P>(block.field + p);
      // Only slots beside valid ones have neighbours that may be loaded.
      if (xsimd::any(load<P>(block.valid + p) > P(T(0.5)))) {
        P sum = zero;
        for (int axis = 0; axis < D; ++axis) {
          sum = sum + xsimd::select(valid_lanes<P>(block.valid + p, line[axis]),
                                    fourth_difference<P>(block.field + p, line[axis]), zero);
        }
        value = fused_minus(factor, sum, value);
      }
      value.store_unaligned(block.filtered + p);
    }
  }
}

}  // namespace pliant::kernels
