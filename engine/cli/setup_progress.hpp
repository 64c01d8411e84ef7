#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <thread>

namespace pliant::cli {

/// Shows on stderr, from a thread of its own, how much of the memory that a run will need is in
/// use: one line redrawn in place on a terminal, a line every few seconds elsewhere. A set-up of
/// less than a second shows nothing.
class SetupProgress {
 public:
  /// Begins; `expected` is the size of the whole run [bytes].
  explicit SetupProgress(std::size_t expected);
  SetupProgress(const SetupProgress&) = delete;
  SetupProgress& operator=(const SetupProgress&) = delete;

  /// Ends, and clears the line. The destructor does the same.
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
