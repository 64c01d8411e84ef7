#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

/// Runs of many cases, and what is known of them.
void add_batch_commands(Commands& commands);

}  // namespace pliant::cli
