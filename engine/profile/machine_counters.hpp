#pragma once

namespace pliant::profile {

/// Counters of Linux, to distinguish delays of the program from those of the machine.
struct MachineCounters {
  double processor_seconds = 0;   ///< of all threads of this process
  double stolen_seconds = 0;      ///< time that the host of a virtual machine gave to other guests
  long involuntary_switches = 0;  ///< how often threads of this process had to leave a processor

  static MachineCounters now();
  MachineCounters operator-(const MachineCounters& earlier) const;
};

/// Mean number of runnable threads in the last minute; negative if it is unknown.
double load_average();

}  // namespace pliant::profile
