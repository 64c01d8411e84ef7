#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace pliant::bench {

/// A pliant in a process of its own that measures one row, a turn at a time (turns.hpp).
class MeasuredProgram {
 public:
  /// Starts it; the set-up goes on beside the caller. Throws InputError where no process can be
  /// made.
  MeasuredProgram(std::filesystem::path program, std::string row, int threads);
  MeasuredProgram(const MeasuredProgram&) = delete;
  MeasuredProgram& operator=(const MeasuredProgram&) = delete;
  ~MeasuredProgram();

  /// Rate of its next turn [particle-stages/s]. Throws InputError where it gives none.
  double turn();

 private:
  std::filesystem::path program_;
  std::string row_;
  int connection_ = -1;  ///< a socket: its standard input and output
  pid_t process_ = -1;
};

}  // namespace pliant::bench
