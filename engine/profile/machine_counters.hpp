#pragma once

namespace pliant::profile {

/// What Linux has counted so far: tells the program's own delays from those of the machine.
struct MachineCounters {
  double processor_seconds = 0;   ///< of all threads of this process
  double stolen_seconds = 0;      ///< that the host of a virtual machine gave to other guests
  long involuntary_switches = 0;  ///< threads of this process that had to leave a processor

  static MachineCounters now();
  MachineCounters operator-(const MachineCounters& earlier) const;
};

/// Mean number of threads that wanted to run in the last minute; negative where it is unknown.
double load_average();

}  // namespace pliant::profile
