#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

/// The page that shows a run or a batch.
void add_report_command(Commands& commands);

}  // namespace pliant::cli
