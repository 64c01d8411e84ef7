#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

/// Adds the commands for batches of runs.
void add_batch_commands(Commands& commands);

}  // namespace pliant::cli
