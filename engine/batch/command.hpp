#pragma once

#include <string>
#include <vector>

namespace pliant::batch {

/// Exit status and output of a program.
struct CommandResult {
  int status = 0;  ///< 127: there is no such program
  std::string output;
  std::string errors;
};

/// Runs a program of PATH and waits for its end. Throws OutputError where no process can be made.
CommandResult run_command(std::vector<std::string> command);

}  // namespace pliant::batch
