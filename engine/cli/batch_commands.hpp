#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

void add_batch_commands(Commands& commands);

}  // namespace pliant::cli
