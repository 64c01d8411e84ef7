#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Reads the file of every mesh among the parts of `shape` that is not loaded yet, and puts the
/// mesh in its place. Throws MeshError.
void load_meshes(Shape& shape);

}  // namespace pliant
