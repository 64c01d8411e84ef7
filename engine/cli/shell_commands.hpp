#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

void add_shell_commands(Commands& commands);

}  // namespace pliant::cli
