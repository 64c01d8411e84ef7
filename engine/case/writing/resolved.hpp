#pragma once

#include <string>

#include "engine/case/case.hpp"

namespace pliant {

/// The whole case as a case file, with all defaults. Reading it gives an equal case.
std::string resolved_toml(const Case& a_case);

}  // namespace pliant
