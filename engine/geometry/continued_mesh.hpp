#pragma once

#include <memory>

#include "engine/geometry/closed_mesh.hpp"

namespace pliant {

/// `mesh` without the flat side that lies on `wall`, a half-space or a box, joined along the rim of
/// that side to its mirror image behind the wall. Null where no triangle lies on the wall, where
/// the mesh is not wholly in front of it, where a box does not cover the side, and where the mesh
/// touches the wall along an edge alone.
std::shared_ptr<const ClosedMesh> continued_through(const ClosedMesh& mesh, const Shape& wall);

}  // namespace pliant
