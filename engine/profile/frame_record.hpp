#pragma once

#include <cstdint>
#include <vector>

#include "engine/profile/machine_counters.hpp"

namespace pliant::profile {

struct StepTime {
  double simulated_time = 0;  ///< at its end [s]
  double wall_seconds = 0;
};

/// The timing of one frame. The parts of the breakdown are thread time divided by the number of
/// threads; their sum is the wall time.
struct FrameRecord {
  double simulated_time = 0;  ///< at its end [s]
  double wall_seconds = 0;    ///< of its steps
  std::int64_t steps = 0, remeshings = 0;
  std::vector<double> phase_seconds;  ///< [phase], those of the whole profile
  double scheduling_seconds = 0;      ///< see IdleTime
  double waiting_seconds = 0;         ///< see IdleTime
  double serial_seconds = 0;          ///< in steps, outside their graphs
  double load = 0;                    ///< load_average() at its end
  MachineCounters machine;            ///< during the frame
};

}  // namespace pliant::profile
