#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/end_of_child.hpp"
#include "engine/batch/ledger.hpp"
#include "engine/batch/waiting.hpp"
#include "engine/output/interrupt.hpp"

namespace pliant::batch {

/// An attempt of a run, as a process.
class Job {
 public:
  /// Starts it; `folder` is for its results. It continues from a checkpoint where there is one.
  /// Throws OutputError.
  Job(const Waiting& run, const std::filesystem::path& folder, std::vector<std::string> command);

  /// The file that is locked while a process works in the folder of a run.
  static std::filesystem::path lock_of(const std::filesystem::path& folder);
  static bool has_checkpoint(const std::filesystem::path& folder);

  /// Asks the process to end with a checkpoint, once.
  void stop();
  /// Stops it after `seconds`, unless 0, and kills it a while later.
  void keep_limit(double seconds);
  /// When the process has ended: how.
  std::optional<Outcome> outcome();
  /// What follows from it; a run that is pending again has its attempts left in `run`. One that
  /// failed by itself from a checkpoint loses its checkpoints.
  RunStatus settle(const Outcome& outcome, bool interrupted);

  const Waiting& run() const { return run_; }

 private:
  double seconds() const;

  Waiting run_;
  std::filesystem::path folder_;
  bool was_resumed_ = false, is_stopped_ = false, is_late_ = false;
  pid_t process_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Waits for the end of a job, and stops it after `time_limit` [s], unless 0, or when interrupted.
Outcome end_of(Job& job, double time_limit, const EndOfChild& end_of_child,
               const Interrupt& interrupt);

}  // namespace pliant::batch
