#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/case/checks/thickness.hpp"

namespace pliant {

/// Whether a body overhangs a slip wall, with a free surface that leans over it by more than 33
/// degrees.
bool overhangs_a_slip_wall(const Case& a_case, const BodyCase& body);

/// Warns of bodies that overhang a no-slip wall and are so thin in spacings that one of the errors
/// applies; `errors` are in ascending order of `across`.
void warn_of_overhangs(const Case& a_case, std::span<const ThinBodyError> errors,
                       std::vector<std::string>& warnings);

}  // namespace pliant
