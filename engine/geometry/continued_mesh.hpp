#pragma once

#include <memory>

#include "engine/geometry/closed_mesh.hpp"

namespace pliant {

/// `mesh` without the flat side that lies on `wall` (a half-space or a box), joined at the rim of
/// that side to its mirror image behind the wall. Null if no triangle lies on the wall, if the mesh
/// is not wholly in front of it, if a box does not cover the side, or if the mesh touches the wall
/// only along an edge.
std::shared_ptr<const ClosedMesh> continued_through(const ClosedMesh& mesh, const Shape& wall);

}  // namespace pliant
