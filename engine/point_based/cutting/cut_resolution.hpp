#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::point_based {

/// Adds a warning for each cut that advances by so few spacings that the opening beside it is off
/// by more than some percent, and one where the rule of the cuts may not divide the body.
void warn_of_coarse_cuts(const Case& settings, std::vector<std::string>& warnings);

}  // namespace pliant::point_based
