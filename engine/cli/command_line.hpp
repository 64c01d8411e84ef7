#pragma once

#include <functional>

#include "engine/cli/actions.hpp"

namespace pliant::cli {

/// What the command line asks for. Prints help and the version itself, and returns what does
/// nothing more. Throws InputError for a command line that cannot be understood.
std::function<ExitStatus()> read_command_line(int argc, const char* const* argv);

}  // namespace pliant::cli
