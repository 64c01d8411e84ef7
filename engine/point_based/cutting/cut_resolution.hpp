#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::point_based {

/// Adds a warning for each cut that is too short in spacings, so that its opening is wrong by more
/// than some percent, and a warning if the rule of the cuts may not divide the body.
void warn_of_coarse_cuts(const Case& settings, std::vector<std::string>& warnings);

}  // namespace pliant::point_based
