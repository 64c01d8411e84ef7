#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::point_based {

/// Adds a warning for each body whose nodes are too few across for its bending, its twisting, or
/// the stresses that are measured near its surface.
void warn_of_coarse_points(const Case& a_case, std::vector<std::string>& warnings);

}  // namespace pliant::point_based
