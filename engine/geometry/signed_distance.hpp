#pragma once

#include "engine/blocks/box.hpp"
#include "engine/geometry/shape.hpp"

/// Signed distances to shapes: negative inside. In 2D the z components are ignored.
namespace pliant {

/// Distance from `x` to the surface of `shape` [m], negative inside. Exact for box, ball, capsule,
/// cylinder, half-space and mesh. For unions, differences and intersections it is the smaller or
/// the larger of the parts' distances, which has the right sign and is exact near the surface of
/// one part.
double signed_distance(const Shape& shape, const Vector& x, int dimension);

/// Unit vector along which `signed_distance` grows fastest at `x`; on the surface, the outward
/// normal. If several surface points are nearest, it belongs to one of them.
Vector outward_direction(const Shape& shape, const Vector& x, int dimension);

/// Whether a part of `shape` is a mesh, whose distances are expensive.
bool contains_mesh(const Shape& shape);

/// A box that contains `shape`; infinite in directions in which the shape is infinite.
Box<3> bounding_box(const Shape& shape);

}  // namespace pliant
