#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/geometry/shape.hpp"

/// Triangles as in files.
namespace pliant {

/// An error in a mesh file (with its line or byte, if known), and what to do.
class MeshError : public std::runtime_error {
 public:
  MeshError(const std::string& what, std::string remedy)
      : std::runtime_error(what), remedy_(std::move(remedy)) {}
  const std::string& remedy() const { return remedy_; }

 private:
  std::string remedy_;
};

using Triangle = std::array<std::int32_t, 3>;  ///< vertices, counter-clockwise seen from outside

/// A surface of triangles.
struct SurfaceMesh {
  std::vector<Vector> vertices;  ///< in the unit of the file; finite
  std::vector<Triangle> triangles;
  std::size_t elements = 0;  ///< inside, where the surface is that of a mesh of tetrahedra
};

/// Reads a file with the extension .stl (ASCII or binary), .obj (polygons become fans of triangles)
/// or .ply (ASCII or binary little endian), or the boundary of the tetrahedra of a .msh or .vtk
/// file. Throws MeshError.
SurfaceMesh read_mesh(const std::filesystem::path& file);

}  // namespace pliant
