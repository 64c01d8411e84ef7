#include "engine/geometry/mesh_files/load_meshes.hpp"

#include <utility>

#include "engine/geometry/closed_mesh.hpp"

namespace pliant {

void load_meshes(Shape& shape) {
  for (Shape& part : shape.operands) load_meshes(part);
  if (shape.kind != Shape::Kind::mesh || shape.mesh) return;
  SurfaceMesh mesh = read_mesh(shape.file);
  for (Vector& vertex : mesh.vertices) {
    for (int i = 0; i < 3; ++i) vertex[i] = shape.scale * vertex[i] + shape.translate[i];
  }
  shape.mesh = std::make_shared<const ClosedMesh>(std::move(mesh), shape.file);
}

}  // namespace pliant
