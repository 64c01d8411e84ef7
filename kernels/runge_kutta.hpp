#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// Where the states of one field lie while a stage advances it.
template <class T>
struct StageField {
  const T* current;
  const T* start;
  const T* second;
  const T* third;
  T* next;
};

/// (RP.19): Q2, Q3, Q4 after the first three stages (`last` = false), Q_new after the last.
///
/// The last stage sums differences from Q0, so that what does not change keeps its bits.
template <class P, bool last>
class RungeKutta {
  using T = Scalar<P>;

 public:
  RungeKutta(T time_step, int stage)
      : factor_(last         ? time_step / 6
                : stage == 2 ? time_step
                             : time_step / 2) {}

  void advance(const StageField<T>& field, std::int64_t slot, const P& rate) const {
    const P start = load<P>(field.start + slot);
    if constexpr (last) {
      const P second = load<P>(field.second + slot) - start;
      const P third = load<P>(field.third + slot) - start;
      const P fourth = load<P>(field.current + slot) - start;
      const P mean = fused(P(T(2)), third, second + fourth) * P(T(1) / T(3));
      (start + fused(rate, factor_, mean)).store_unaligned(field.next + slot);
    } else {
      fused(rate, factor_, start).store_unaligned(field.next + slot);
    }
  }

 private:
  P factor_;
};

}  // namespace pliant::kernels
