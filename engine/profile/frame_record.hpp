#pragma once

#include <cstdint>
#include <vector>

#include "engine/profile/machine_counters.hpp"

namespace pliant::profile {

struct StepTime {
  double simulated_time = 0;  ///< at its end [s]
  double wall_seconds = 0;
};

/// What one frame took. The times of the breakdown are thread time over the number of threads; they
/// add up to the wall time.
struct FrameRecord {
  double simulated_time = 0;  ///< at its end [s]
  double wall_seconds = 0;    ///< of its steps
  std::int64_t steps = 0, remeshings = 0;
  std::vector<double> phase_seconds;  ///< [phase], those of the whole profile
  double scheduling_seconds = 0;      ///< of IdleTime
  double waiting_seconds = 0;         ///< of IdleTime
  double serial_seconds = 0;          ///< of the steps, outside their graphs
  double load = 0;                    ///< load_average() at its end
  MachineCounters machine;            ///< during the frame
};

}  // namespace pliant::profile
