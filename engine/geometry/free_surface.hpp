#pragma once

#include <span>

#include "engine/geometry/shape.hpp"

/// Where a body's free surface is at t = 0.
///
/// A body that is attached to a wall has no free surface there: the level set describes its free
/// surface alone and continues through the wall (and through the ends of a periodic cell).
///
///        wall | body            phi = 0 along the top and the bottom only,
///     --------+---------        and along both dashed lines inside the wall
///        phi < 0 here too
///     --------+---------
///             |
namespace pliant {

/// `body` with every box face that lies against a face of one of `walls` (a half-space or a box)
/// moved to infinity. A face that a wall covers in part is extended over that part. A half-space
/// that cuts the body where a wall is the same plane cuts nothing off. A mesh whose flat side lies
/// on a wall gives way there to its mirror image, which joins it along the rim of that side.
Shape free_surface(const Shape& body, std::span<const Shape> walls, int dimension);

}  // namespace pliant
