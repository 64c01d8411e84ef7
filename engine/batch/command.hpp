#pragma once

#include <string>
#include <vector>

namespace pliant::batch {

struct CommandResult {
  int status = 0;  ///< 127: the program does not exist
  std::string output;
  std::string errors;
};

/// Runs a program from PATH and waits for its end. Throws OutputError if no process can be created.
CommandResult run_command(std::vector<std::string> command);

}  // namespace pliant::batch
