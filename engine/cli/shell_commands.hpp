#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

/// Adds the commands for shells, `man` and editors.
void add_shell_commands(Commands& commands);

}  // namespace pliant::cli
