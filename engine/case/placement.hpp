#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// What of a case has no effect because of where it is at the start: walls that touch no body,
/// loads whose regions hold no surface, blades that pass beside their body. One sentence each, with
/// what to do. Shapes count as touching when less than about a spacing lies between them.
std::vector<std::string> placement_warnings(const Case& a_case);

}  // namespace pliant
