#include <fmt/format.h>

#include "engine/geometry/mesh_files/volume_mesh_file.hpp"

namespace pliant {

SurfaceMesh read_mesh(const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  if (ending == ".msh" || ending == ".vtk") return boundary_of(read_volume_mesh(file, 3));
  const MeshFile loaded = load_mesh_file(file);
  SurfaceMesh mesh;
  if (ending == ".stl") {
    mesh = read_stl(loaded);
  } else if (ending == ".obj") {
    mesh = read_obj(loaded);
  } else if (ending == ".ply") {
    mesh = read_ply(loaded);
  } else {
    throw MeshError(
        fmt::format("{}: no format is known by the ending \"{}\"", loaded.name, ending),
        "give a surface that ends in .stl, .obj or .ply, or tetrahedra that end in .msh or .vtk");
  }
  if (!mesh.triangles.empty()) return mesh;
  throw MeshError(fmt::format("{}: holds no triangle", loaded.name),
                  "export the surface with its faces");
}

VolumeMesh read_volume_mesh(const std::filesystem::path& file, int dimension) {
  const std::string ending = lower_ending(file);
  const MeshFile loaded = load_mesh_file(file);
  if (ending == ".msh") return read_gmsh(loaded, dimension);
  if (ending == ".vtk") return read_vtk(loaded, dimension);
  throw MeshError(fmt::format("{}: no format of volume meshes is known by the ending \"{}\"",
                              loaded.name, ending),
                  "give a Gmsh or a legacy VTK file that ends in .msh or .vtk");
}

}  // namespace pliant
