#include "engine/profile/machine_counters.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace pliant::profile {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// The first line of /proc/stat: "cpu user nice system idle iowait irq softirq steal ...".
double stolen_seconds() {
  std::ifstream file("/proc/stat");
  std::string word;
  double ticks = 0;
  file >> word;
  for (int column = 0; column < 8; ++column) file >> ticks;
  return file ? ticks / static_cast<double>(sysconf(_SC_CLK_TCK)) : 0;
}

}  // namespace

MachineCounters MachineCounters::now() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), pliant::profile::stolen_seconds(),
          usage.ru_nivcsw};
}

MachineCounters MachineCounters::operator-(const MachineCounters& earlier) const {
  return {processor_seconds - earlier.processor_seconds, stolen_seconds - earlier.stolen_seconds,
          involuntary_switches - earlier.involuntary_switches};
}

double load_average() {
  double load = -1;
  return getloadavg(&load, 1) == 1 ? load : -1;
}

}  // namespace pliant::profile
