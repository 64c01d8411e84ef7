#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace pliant::bench {

/// A pliant process that measures one row, one turn at a time (turns.hpp).
class MeasuredProgram {
 public:
  /// Starts the process, which sets up in parallel with the caller. Throws InputError if no process
  /// can be created.
  MeasuredProgram(std::filesystem::path program, std::string row, int threads);
  MeasuredProgram(const MeasuredProgram&) = delete;
  MeasuredProgram& operator=(const MeasuredProgram&) = delete;
  ~MeasuredProgram();

  /// Rate of its next turn [particle-stages/s]. Throws InputError if it returns none.
  double turn();

 private:
  std::filesystem::path program_;
  std::string row_;
  int connection_ = -1;  ///< a socket for its standard input and output
  pid_t process_ = -1;
};

}  // namespace pliant::bench
