#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/undeformed/secant.hpp"

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
  bool samples;  ///< whether to take a sample of the motion for adaptive damping, (TL.10)

  /// How long the forces of central differences act, (TL.8) [s].
  double kick() const { return (previous + length) / 2; }
};

/// Results of a step about the state at its end.
struct StepResult {
  std::int64_t non_finite = -1;  ///< a slot, or -1
  int failed_block = -1;         ///< block of that slot
  std::optional<Overlap> overlap;
  Secant secant;  ///< if the step has taken a sample
};

}  // namespace pliant::undeformed
