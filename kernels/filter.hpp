#pragma once

#include "kernels/pack.hpp"
#include "kernels/table.hpp"

namespace pliant::kernels {

/// delta^4 f at a register of slots, from the slots `stride` apart; zero where one of the five
/// slots is not valid.
template <class P>
inline P fourth_difference(const Scalar<P>* field, const Scalar<P>* valid,
                           const std::int64_t (&slot)[5]) {
  using T = Scalar<P>;
  P all_valid = load<P>(valid + slot[0]);
  for (int k = 1; k < 5; ++k) all_valid = all_valid * load<P>(valid + slot[k]);
  const P outer = load<P>(field + slot[0]) + load<P>(field + slot[4]);
  const P inner = load<P>(field + slot[1]) + load<P>(field + slot[3]);
  const P centre = load<P>(field + slot[2]);
  const P difference = fused(P(T(6)), centre, fused_minus(P(T(4)), inner, outer));
  return xsimd::select(all_valid > P(T(0.5)), difference, P(T(0)));
}

/// See Filter, (RP.27).
template <class P, int D>
void filter(const Filter<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  const P factor(block.strength / T(16));
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += lanes<P>) {
      const P value = load<P>(block.field + p);
      // Only slots beside valid ones have neighbours that may be loaded.
      if (!xsimd::any(load<P>(block.valid + p) > P(T(0.5)))) {
        value.store_unaligned(block.filtered + p);
        continue;
      }
      P sum = fourth_difference<P>(block.field, block.valid, {p - 2, p - 1, p, p + 1, p + 2});
      for (int axis = 1; axis < D; ++axis) {
        std::int64_t slot[5];
        for (int k = 0; k < 5; ++k) {
          slot[k] =
              p +
              segment.neighbour_row[axis == 1 ? row_index<D>(k - 2, 0) : row_index<D>(0, k - 2)];
        }
        sum = sum + fourth_difference<P>(block.field, block.valid, slot);
      }
      fused_minus(factor, sum, value).store_unaligned(block.filtered + p);
    }
  }
}

}  // namespace pliant::kernels
