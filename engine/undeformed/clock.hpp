#pragma once

#include <cstdint>

#include "engine/method/step_clock.hpp"

namespace pliant::undeformed {

/// Counters that the next step reads; a checkpoint holds all of them. The wave speed is that
/// without mass scaling.
struct Clock : StepClock {
  double mass_scaling = 1;           ///< inertia over mass in the next step
  std::int64_t next_sample = 0;      ///< step that takes the next sample of the motion, (TL.10)
  std::int64_t sample_interval = 1;  ///< steps from the sample before to that one
  double step_length = 0;            ///< of the last step that has begun [s]; 0 before the first
  double step_end = 0;               ///< end of that step [s]
  double velocity_time = 0;          ///< time of the velocities [s]

  /// Rest of that step after an output time inside it [s]; 0 if it has ended.
  double rest() const { return step_end - time > rounding() ? step_end - time : 0; }
  /// An impulse that acts for `duration` [s] over the change of momentum that it causes without
  /// mass scaling, (TL.8).
  double inertia(double duration) const { return mass_scaling * (1 + damping * duration / 2); }
  /// Time from that of the velocities to `time` [s].
  double lag() const { return time - velocity_time; }
  /// Times closer to each other than this count as equal [s].
  double rounding() const { return 1e-9 * step_length; }
};

}  // namespace pliant::undeformed
