#pragma once

#include <string>

#include "engine/cli/command_model.hpp"

namespace pliant::cli {

/// The manual page pliant(1) in roff.
std::string manual_page(const CommandModel& program);

}  // namespace pliant::cli
