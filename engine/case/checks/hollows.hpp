#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/case/checks/thickness.hpp"

namespace pliant {

/// Adds a warning for each body with a free round hole or hollow whose radius is too small in
/// spacings; `errors` are in ascending order of `across`, here the radius.
void warn_of_small_hollows(const Case& a_case, std::span<const ThinBodyError> errors,
                           std::vector<std::string>& warnings);

}  // namespace pliant
