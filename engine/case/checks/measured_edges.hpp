#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Adds a warning for each body of which something is measured at a point within a spacing of an
/// edge or a corner whose faces are at an angle to the axes; `deviation` says what is wrong there.
void warn_of_measured_edges(const Case& a_case, std::string_view deviation,
                            std::vector<std::string>& warnings);

}  // namespace pliant
