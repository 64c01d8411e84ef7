#pragma once

#include <string>

#include "engine/cli/command_model.hpp"

namespace pliant::cli {

/// Scripts that complete the command line in a shell.
std::string bash_completion(const CommandModel& program);
std::string zsh_completion(const CommandModel& program);
std::string fish_completion(const CommandModel& program);

}  // namespace pliant::cli
