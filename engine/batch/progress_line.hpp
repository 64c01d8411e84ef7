#pragma once

#include <chrono>
#include <cstddef>

namespace pliant::batch {

/// Shows the progress of a batch on stderr: one line that is redrawn on a terminal, else a line
/// every few seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet) : quiet_(quiet) {}

  int all = 0, done = 0, failed = 0;

  /// Adds the time of a run to the estimate of the remaining time.
  void add_run(double seconds);
  void show(std::size_t running, int workers);
  /// Writes the last state and ends the line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void write(std::size_t running, int workers);

  bool quiet_;
  double run_seconds_ = 0;
  int runs_ = 0;
  Clock::time_point written_ = Clock::now();
};

}  // namespace pliant::batch
