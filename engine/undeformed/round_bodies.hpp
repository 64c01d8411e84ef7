#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/case/checks/thickness.hpp"

namespace pliant::undeformed {

/// Warns of discs, balls, capsules and cylinders, and of bodies with such parts, that may touch
/// walls or other bodies and are so thin in spacings that one of the errors applies; `errors` are
/// in ascending order of `across`.
void warn_of_round_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                          std::vector<std::string>& warnings);

}  // namespace pliant::undeformed
