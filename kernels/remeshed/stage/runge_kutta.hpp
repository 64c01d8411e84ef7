#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// Where the states of one field lie while a stage advances it; see Stage.
template <class T>
struct StageField {
  const T* current;
  T* start;
  const T* second;
  const T* third;
  T* next;
};

enum class StagePlace { early, third, last };

/// (RP.21) with three copies of the state: Q2, Q3 after the first two stages, Q4 after the third,
/// which leaves Q3 + (Q2 - Q0)/3 in the place of Q0, and Q_new after the last, which adds
/// (Q4 - Q3)/3 + dt/6 k4.
///
/// Both add differences, so that what does not change keeps its bits.
template <class P, StagePlace place>
class RungeKutta {
  using T = Scalar<P>;

 public:
  explicit RungeKutta(T time_step)
      : factor_(place == StagePlace::last    ? time_step / 6
                : place == StagePlace::third ? time_step
                                             : time_step / 2) {}

  void advance(const StageField<T>& field, std::int64_t slot, const P& rate) const {
    const P start = load<P>(field.start + slot);
    P base = start;
    if constexpr (place == StagePlace::third) {
      const P change = load<P>(field.second + slot) - start;
      fused(change, third_, load<P>(field.current + slot)).store_unaligned(field.start + slot);
    } else if constexpr (place == StagePlace::last) {
      const P change = load<P>(field.current + slot) - load<P>(field.third + slot);
      base = fused(change, third_, start);
    }
    fused(rate, factor_, base).store_unaligned(field.next + slot);
  }

 private:
  P factor_, third_ = P(T(1) / T(3));
};

}  // namespace pliant::kernels
