#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Loads every mesh in `shape` that is not loaded yet from its file. Throws MeshError.
void load_meshes(Shape& shape);

}  // namespace pliant
