#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/geometry/surface_mesh.hpp"

/// Meshes that fill a body: tetrahedra in 3D, triangles in 2D.
namespace pliant {

/// Tetrahedra, or triangles in 2D, between shared vertices.
struct VolumeMesh {
  int dimension = 3;
  std::vector<Vector> vertices;  ///< in the unit of the file; each belongs to an element
  /// [element] corners of a tetrahedron with positive volume; in 2D of a counter-clockwise
  /// triangle, and the last one is -1.
  std::vector<std::array<std::int32_t, 4>> elements;
};

/// Reads elements with four nodes (dimension 3) or triangles with three nodes (dimension 2) from a
/// Gmsh file of version 2.2 or 4.1 (.msh, text or binary) or a legacy VTK file (.vtk, text or
/// binary). Points, lines and, in 3D, surface elements are skipped. If all elements are inverted,
/// the mesh is flipped. Throws MeshError, with the line or byte, for other elements, inverted or
/// flat elements, two nodes at one place, facets of more than two elements, nodes that are not
/// finite, and numbers of rows that the file does not have.
VolumeMesh read_volume_mesh(const std::filesystem::path& file, int dimension);

/// Volume of element `e` in the cube of the file's unit; in 2D its area.
double element_volume(const VolumeMesh& mesh, std::size_t e);

/// The facets that belong to only one tetrahedron, ordered as seen from outside.
SurfaceMesh boundary_of(const VolumeMesh& mesh);

}  // namespace pliant
