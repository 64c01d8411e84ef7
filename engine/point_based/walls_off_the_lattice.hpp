#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::point_based {

/// Warns of bodies of few particles at walls that lie at an angle to the lattice, at curved slip
/// walls, and around balls that hold them.
void warn_of_walls_off_the_lattice(const Case& a_case, std::vector<std::string>& warnings);

}  // namespace pliant::point_based
