#pragma once

#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

/// Solids through which the free surface of a body continues: fixed, moving and slip walls, and a
/// half-space beyond each end of the periodic cell.
std::vector<Shape> attached_walls(const Case& a_case);

/// The free surface of a body at t = 0.
Shape initial_surface(const Case& a_case, const BodyCase& body);

}  // namespace pliant
