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

/// A component of the drift and of the velocity, its rate, while a stage advances the drift.
template <class T>
struct DriftField {
  const T* current;
  const T* start;
  T* next;
  StageField<T> velocity;
};

/// (RP.21) of the drift with two copies: Q3 takes the place of Q0, Q4 that of Q2, and Q_new that of
/// Q3. What is missing follows from the velocities that the stages have left: Q0 = Q3 - dt/2 u2,
/// and u0 - u2 = -3 (R - u3). Ghosts, which `has_remainders` says nothing of, still have u0 where R
/// is.
///
/// Has to come before the velocity is advanced.
template <class P, StagePlace place, bool has_remainders>
inline void advance_drift(const DriftField<Scalar<P>>& field, Scalar<P> time_step,
                          std::int64_t slot) {
  using T = Scalar<P>;
  const P current = load<P>(field.current + slot), u = load<P>(field.velocity.current + slot);
  P base = load<P>(field.start + slot), rate = u, factor(time_step / 2);
  if constexpr (place == StagePlace::third) {
    rate = fused(P(T(-0.5)), load<P>(field.velocity.second + slot), u);
    factor = P(time_step);
  } else if constexpr (place == StagePlace::last) {
    const P start = load<P>(field.velocity.start + slot);
    if constexpr (has_remainders) {
      const P third = load<P>(field.velocity.third + slot);
      rate = fused(P(T(-3)), start - third, fused(P(T(2)), third, u));
    } else {
      base = fused(current - base, P(T(1) / T(3)), base);
      rate = start + u;
    }
    factor = P(time_step / 6);
  }
  fused(rate, factor, base).store_unaligned(field.next + slot);
}

}  // namespace pliant::kernels
