#pragma once

#include <cstdint>

namespace pliant {

/// The clock of all methods: the counters that the next step reads.
struct StepClock {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double wave_speed = 0;  ///< largest wave speed at the present state [m/s]
  double damping = 0;     ///< alpha of (RP.71), (TL.8) and (PB.10) in the next step [1/s]
};

}  // namespace pliant
