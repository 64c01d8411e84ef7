#pragma once

#include "engine/cli/commands.hpp"

namespace pliant::cli {

void add_report_command(Commands& commands);

}  // namespace pliant::cli
