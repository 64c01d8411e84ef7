#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace pliant::undeformed {

/// A corner of a surface that lies too deep in another body.
struct Overlap {
  int contact;                  ///< of the case
  double depth;                 ///< [m]
  std::array<double, 3> place;  ///< [m], z = 0 in 2D
};

/// How a step advances.
struct Advance {
  double time;      ///< at its start [s]
  double previous;  ///< length of the step before, 0 at the start of a run [s]
  double length;    ///< for how long particles move [s]
  bool examine;     ///< whether to look for the wave speed and for states that are not possible

  /// For how long the forces of central differences act, (TL.8) [s].
  double kick() const { return (previous + length) / 2; }
};

/// What a step finds about the state that it leaves behind.
struct StepResult {
  std::int64_t non_finite = -1;  ///< a slot, or -1
  int failed_block = -1;         ///< that the slot belongs to
  std::optional<Overlap> overlap;
};

}  // namespace pliant::undeformed
