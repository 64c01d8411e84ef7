#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/batch/ledger.hpp"

namespace pliant::batch {

/// An attempt of a run, as a process.
class Job {
 public:
  /// Starts it; `folder` is for its results. It continues from a checkpoint where there is one.
  /// Throws OutputError.
  Job(const Assignment& parameters, int attempts_left, std::size_t bytes,
      const std::filesystem::path& folder, std::vector<std::string> command);

  /// The file that is locked while a process works in the folder of a run.
  static std::filesystem::path lock_of(const std::filesystem::path& folder);

  /// Asks the process to end with a checkpoint, once.
  void stop();
  /// Stops it after `seconds`, unless 0, and kills it a while later.
  void keep_limit(double seconds);
  /// When the process has ended: how.
  std::optional<Outcome> outcome();

  const Assignment& parameters() const { return parameters_; }
  const std::string& name() const { return name_; }
  int attempts_left() const { return attempts_left_; }
  std::size_t bytes() const { return bytes_; }
  bool was_resumed() const { return was_resumed_; }
  /// Whether it ended without a signal from outside: it might do better without its checkpoint.
  bool failed_by_itself(const Outcome& outcome) const;
  void remove_checkpoints() const;

 private:
  double seconds() const;

  Assignment parameters_;
  std::string name_;
  int attempts_left_;
  std::size_t bytes_;
  std::filesystem::path folder_;
  bool was_resumed_ = false, is_stopped_ = false, is_late_ = false;
  pid_t process_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace pliant::batch
