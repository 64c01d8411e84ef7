#pragma once

#include <cstdint>

namespace pliant {

/// The clock of all methods: the counters that the next step reads.
struct StepClock {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double wave_speed = 0;  ///< largest wave speed at the present state [m/s]
};

}  // namespace pliant
