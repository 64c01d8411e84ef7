#pragma once

#include <string>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant::point_based {

/// Warns of walls without slip that cut elements of a mesh: they hold its nodes, which lie
/// elsewhere than the walls.
void warn_of_walls_in_meshes(const Case& a_case, std::vector<std::string>& warnings);

}  // namespace pliant::point_based
