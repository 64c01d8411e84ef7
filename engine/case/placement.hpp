#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Parts of a case without effect at their place at t = 0: walls that touch no body, loads whose
/// regions contain no surface, blades that miss their body. One sentence for each, with what to do.
/// Shapes less than about a spacing apart count as touching.
std::vector<std::string> placement_warnings(const Case& a_case);

}  // namespace pliant
