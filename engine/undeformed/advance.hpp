#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pliant::undeformed {

/// A corner of a surface that is too deep inside another body.
struct Overlap {
  int contact;                  ///< of the case
  double depth;                 ///< [m]
  std::array<double, 3> place;  ///< [m], z = 0 in 2D
};

/// How a step advances.
struct Advance {
  double time;      ///< time at the start of the step [s]
  double previous;  ///< length of the step before, 0 at the start of a run [s]
  double length;    ///< how long particles move [s]
  bool examine;  ///< whether to compute the wave speed and to look for states that are not possible

  /// How long the forces of central differences act, (TL.8) [s].
  double kick() const { return (previous + length) / 2; }
};

/// Results of a step about the state at its end.
struct StepResult {
  std::int64_t non_finite = -1;  ///< a slot, or -1
  int failed_block = -1;         ///< block of that slot
  std::optional<Overlap> overlap;
  double rayleigh = 0;  ///< dt omega^2 of (TL.10), without mass scaling [1/s]; 0 unless computed
};

/// `StepResult::rayleigh` from the sums of u.(F(t - dt') - F(t)) [W] and of m u^2 [J].
inline double rayleigh_quotient(double stiffness, double inertia) {
  return stiffness > 0 && inertia > 0 ? stiffness / inertia : 0;
}

/// The rate of adaptive damping after a step, (TL.10) [1/s].
inline double critical_damping(const Advance& advance, const StepResult& result,
                               double mass_scaling) {
  if (advance.previous == 0) return 0;
  const double frequency2 = result.rayleigh / (advance.previous * mass_scaling);
  return std::min(2 * std::sqrt(frequency2), 1 / advance.length);
}

}  // namespace pliant::undeformed
