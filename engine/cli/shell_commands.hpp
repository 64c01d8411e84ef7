#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

/// What shells, `man` and editors know of the program.
void add_shell_commands(Commands& commands);

}  // namespace pliant::cli
