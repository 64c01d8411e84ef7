#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Adds a warning for a case with walls or loads that ends before waves have passed through six
/// spacings, so that what begins with the run is not resolved.
void warn_of_short_runs(const Case& a_case, std::vector<std::string>& warnings);

}  // namespace pliant
