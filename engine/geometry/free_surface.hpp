#pragma once

#include <span>
#include <vector>

#include "engine/case/case.hpp"

/// Where a body's free surface is at t = 0.
///
/// A body that is bonded to a wall has no surface there: the level set describes its free surface
/// alone and runs on through the wall (and through the ends of a periodic cell).
///
///        wall | body            phi = 0 along the top and the bottom only,
///     --------+---------        and along both dashed lines inside the wall
///        phi < 0 here too
///     --------+---------
///             |
namespace pliant {

/// Solids that a body's free surface runs on through: fixed, moving and slip walls, and a
/// half-space beyond each end of the periodic cell.
std::vector<Shape> attached_walls(const Case& a_case);

/// `body` with every box face that lies against a face of one of `walls` (a half-space or a box)
/// moved to infinity. A face that a wall covers in part is extended over that part.
Shape free_surface(const Shape& body, std::span<const Shape> walls, int dimension);

}  // namespace pliant
