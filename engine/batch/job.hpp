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

/// An attempt at a run, as a process.
class Job {
 public:
  /// Starts the process; `folder` is for its results. It continues from a checkpoint if there is
  /// one. Throws OutputError.
  Job(const Waiting& run, const std::filesystem::path& folder, std::vector<std::string> command);

  /// The file that is locked while a process works in the folder of a run.
  static std::filesystem::path lock_of(const std::filesystem::path& folder);
  static bool has_checkpoint(const std::filesystem::path& folder);

  /// Asks the process once to end with a checkpoint.
  void stop();
  /// Stops it after `seconds`, unless 0, and kills it some time later.
  void keep_limit(double seconds);
  /// The outcome, when the process has ended.
  std::optional<Outcome> outcome();
  /// The status that follows from the outcome. Updates the attempts left of `run`. Removes the
  /// checkpoints of a run that failed on its own after continuing from one.
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

/// Waits for the end of a job; stops it after `time_limit` [s], unless 0, or when interrupted.
Outcome end_of(Job& job, double time_limit, const EndOfChild& end_of_child,
               const Interrupt& interrupt);

}  // namespace pliant::batch
