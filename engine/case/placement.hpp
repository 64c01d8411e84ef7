#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Parts of a case without effect because of their place at t = 0: walls that touch no body, loads
/// whose regions contain no surface, blades that miss their body. One sentence for each, with what
/// to do. Shapes count as touching if their distance is less than about a spacing.
std::vector<std::string> placement_warnings(const Case& a_case);

}  // namespace pliant
