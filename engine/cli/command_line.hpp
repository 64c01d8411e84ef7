#pragma once

#include <functional>

#include "engine/cli/actions.hpp"

namespace pliant::cli {

/// The action that the command line requests. Prints help and the version itself, and then returns
/// an action that does nothing. Throws InputError for an invalid command line.
std::function<ExitStatus()> read_command_line(int argc, const char* const* argv);

}  // namespace pliant::cli
