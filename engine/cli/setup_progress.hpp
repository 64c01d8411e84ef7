#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <thread>

namespace pliant::cli {

/// Shows on stderr, from its own thread, how much of the memory for a run is in use: one line that
/// is redrawn on a terminal, else a line every few seconds. Shows nothing in the first second.
class SetupProgress {
 public:
  /// Starts; `expected` is the memory of the whole run [B].
  explicit SetupProgress(std::size_t expected);
  SetupProgress(const SetupProgress&) = delete;
  SetupProgress& operator=(const SetupProgress&) = delete;

  /// Ends and clears the line. The destructor does the same.
  void finish();
  ~SetupProgress() { finish(); }

 private:
  void show(const std::stop_token& stop);

  std::size_t expected_;
  bool is_terminal_;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;
};

}  // namespace pliant::cli
