#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/case/checks/thickness.hpp"

/// Gaps and thin parts of bodies that are otherwise thick. Their width is that along a normal, to a
/// face nearly parallel to the first one: notches and wedges count from 18 degrees down.
namespace pliant {

/// Adds a warning for each body with a gap, such as a slot, that is too narrow in spacings;
/// `errors` are in ascending order of `across`, here the width.
void warn_of_narrow_gaps(const Case& a_case, std::span<const ThinBodyError> errors,
                         std::vector<std::string>& warnings);

/// The same for a part, such as a fin, that is thinner than the rest of its body.
void warn_of_thin_parts(const Case& a_case, std::span<const ThinBodyError> errors,
                        std::vector<std::string>& warnings);

}  // namespace pliant
