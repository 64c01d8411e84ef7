#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

/// Adds the command that writes the page of a run or a batch.
void add_report_command(Commands& commands);

}  // namespace pliant::cli
