#pragma once

#include <cstdint>

#include "engine/case/case.hpp"

namespace pliant {

/// Counters that the next step of any method reads.
struct StepClock {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double wave_speed = 0;  ///< largest, at the present state [m/s]
};

/// Length of the next step [s]: `asked`, or `longest` where that is shorter but for rounding.
/// Throws StepFailure when it is next to nothing, or no number.
double step_length(const Case& settings, const StepClock& clock, double asked, double longest);

}  // namespace pliant
