#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::undeformed {

/// A case whose bodies end at its slip walls: a slip wall holds particles along its normal only, so
/// that material inside it would still resist. Bodies of which `has_elements` is true stay as they
/// are.
Case ended_at_slip_walls(const Case& a_case, bool (*has_elements)(const Shape&));

/// Warns of bodies that cannot end at a slip wall, since they consist of the elements of a mesh.
void warn_of_elements_in_slip_walls(const Case& a_case, bool (*has_elements)(const Shape&),
                                    std::vector<std::string>& warnings);

}  // namespace pliant::undeformed
