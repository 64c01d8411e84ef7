#pragma once

#include <span>

#include "engine/geometry/shape.hpp"

/// The free surface of a body at t = 0.
///
/// A body has no free surface at a wall that it is attached to. The level set describes only its
/// free surface, and continues through the wall (and through the ends of a periodic cell).
///
///        wall | body            phi = 0 only along the top and the bottom,
///     --------+---------        and along their dashed extensions inside the wall
///        phi < 0 here too
///     --------+---------
///             |
namespace pliant {

/// Walls hold faces up to this far in front of them [spacings]: no lattice can tell whether they
/// touch.
inline constexpr double farthest_held = 0.5;

/// `body` with every box face that lies against a face of one of `walls` (a half-space or a box),
/// or inside the wall, moved to infinity. A face that a wall covers in part is extended over that
/// part. A half-space that cuts the body in the plane of a wall, or inside it, is ignored. A mesh
/// whose flat side lies there is joined, along the rim of that side, to its mirror image. Faces lie
/// against a wall up to a distance of `gap` [m].
Shape free_surface(const Shape& body, std::span<const Shape> walls, int dimension, double gap = 0);

}  // namespace pliant
