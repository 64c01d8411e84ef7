#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/case/checks/thickness.hpp"

namespace pliant::undeformed {

/// Warns of bodies in 3D that a no-slip wall squeezes, with a Poisson's ratio of
/// at least 0.4, and that are so thin in spacings that one of the errors applies; `errors` are in
/// ascending order of `across`.
void warn_of_squeezed_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                             std::vector<std::string>& warnings);

}  // namespace pliant::undeformed
