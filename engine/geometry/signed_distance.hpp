#pragma once

#include "engine/blocks/box.hpp"
#include "engine/geometry/shape.hpp"

/// Signed distances to shapes: negative inside. In 2D the z components are ignored.
namespace pliant {

/// Distance from `x` to the surface of `shape` [m], negative inside. Exact for box, ball, cylinder,
/// half-space and mesh; united, subtracted and intersected shapes take the smaller or the larger of
/// their parts' distances, which has the right sign and is exact near one part's surface.
double signed_distance(const Shape& shape, const Vector& x, int dimension);

/// Unit vector along which `signed_distance` grows fastest at `x`: on the surface, the outward
/// normal. At a point with no single nearest surface point, one of those it could be.
Vector outward_direction(const Shape& shape, const Vector& x, int dimension);

/// Whether a part of `shape` is a mesh, whose distances take long.
bool contains_mesh(const Shape& shape);

/// A box that holds `shape`; infinite along directions in which it has no end.
Box<3> bounding_box(const Shape& shape);

}  // namespace pliant
