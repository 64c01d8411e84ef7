#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::remeshed {

/// Warns of joints of tied bodies where this method deviates.
void warn_of_ties(const Case& a_case, std::vector<std::string>& warnings);

}  // namespace pliant::remeshed
