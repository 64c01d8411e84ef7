#pragma once

#include <memory>

#include "engine/geometry/closed_mesh.hpp"

namespace pliant {

/// `mesh` without the flat side that lies on `wall` (a half-space or a box), inside it, or up to
/// `gap` [m] in front of it, joined at the rim of that side to its mirror image. Null if no
/// triangle is there, if the mesh reaches deeper into the wall, if a box does not cover the side,
/// or if the mesh touches its plane only along an edge.
std::shared_ptr<const ClosedMesh> continued_through(const ClosedMesh& mesh, const Shape& wall,
                                                    double gap);

}  // namespace pliant
