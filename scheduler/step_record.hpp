#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pliant::scheduler {

/// When and where a node ran in the last step; zeros for junctions.
struct Span {
  double start = 0;  ///< since the step began [s]
  double stop = 0;   ///< [s]
  int worker = 0;
};

/// The timing of a step. A graph writes it at the end of each run, into memory that it keeps;
/// bench, profile, trace and summary only read it.
///
/// All phases with the same name share a timer.
struct StepRecord {
  double simulated_time = 0;  ///< at the end of the step [s]; set by the caller
  std::chrono::steady_clock::time_point start;
  double wall_seconds = 0;
  std::vector<double> phase_seconds;        ///< [timer] summed over blocks and stages
  std::vector<double> block_seconds;        ///< [timer][block] summed over stages
  std::vector<double> worker_busy_seconds;  ///< [worker] inside phases
  std::vector<Span> spans;                  ///< [node]

  /// Share of the workers' time outside phases: 1 - sum(busy)/(workers wall).
  double idle_share() const;
};

/// Sums of step records over a whole run, across rebuilds of the graph and several graphs.
class StepTotals {
 public:
  /// Adds one step. Allocates only for new timers or workers.
  void add(const StepRecord& record, std::span<const std::string> timer_names);

  struct Timer {
    std::string name;
    double seconds = 0;
  };

  std::int64_t steps() const { return steps_; }
  double wall_seconds() const { return wall_seconds_; }
  const std::vector<Timer>& timers() const { return timers_; }  ///< in order of first appearance
  const std::vector<double>& worker_busy_seconds() const { return worker_busy_seconds_; }

  /// Like StepRecord::idle_share, over all steps.
  double idle_share() const;

 private:
  std::int64_t steps_ = 0;
  double wall_seconds_ = 0;
  std::vector<Timer> timers_;
  std::vector<double> worker_busy_seconds_;
};

}  // namespace pliant::scheduler
