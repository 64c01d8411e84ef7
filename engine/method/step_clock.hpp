#pragma once

#include <cstdint>

namespace pliant {

/// Counters that the next step of any method reads.
struct StepClock {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double wave_speed = 0;  ///< largest, at the present state [m/s]
};

}  // namespace pliant
