#pragma once

#include "kernels/pack.hpp"

namespace pliant::kernels {

/// The states of one field while a stage advances it; see Stage.
template <class T>
struct StageField {
  const T* current;
  T* start;
  const T* second;
  const T* third;
  T* next;
};

enum class StagePlace { early, third, last };

/// (RP.21) with three copies of the state. The first two stages write Q2 and Q3. The third writes
/// Q4, and Q3 + (Q2 - Q0)/3 in the place of Q0; the last adds (Q4 - Q3)/3 + dt/6 k4 to that, which
/// gives Q_new.
///
/// Both add differences, so that a constant value stays bitwise the same.
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

/// A component of the drift, and of the velocity, which is its rate, while a stage advances the
/// drift.
template <class T>
struct DriftField {
  const T* current;
  const T* start;
  T* next;
  StageField<T> velocity;
};

/// (RP.21) of the drift with two copies: Q3 takes the place of Q0, Q4 that of Q2, and Q_new that of
/// Q3. The missing values follow from the velocities that the stages have left: Q0 = Q3 - dt/2 u2,
/// and u0 - u2 = -3 (R - u3). For ghosts, `has_remainders` is false: R still holds u0.
///
/// Must be called before the velocity is advanced.
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
