#pragma once

#include <string>
#include <vector>

#include "engine/geometry/surface_mesh.hpp"

/// How the triangles of a mesh hang together.
namespace pliant {

/// Joins vertices at equal places and drops those that no triangle has.
void join_vertices(SurfaceMesh& mesh);

/// Removes triangles whose corners coincide or lie on a line; says how many.
std::size_t drop_degenerate(SurfaceMesh& mesh);

/// The edge that starts at a corner of a triangle.
struct HalfEdge {
  std::int32_t low, high;  ///< its vertices
  bool forward;            ///< runs from `low` to `high`
  std::int32_t triangle;
  int corner;
};

/// The half-edges of a closed surface, those of each edge next to each other: one forward, one
/// backward. Throws MeshError, which calls the mesh `name`, with the number of other edges and the
/// place of the first.
std::vector<HalfEdge> paired_edges(const SurfaceMesh& mesh, const std::string& name,
                                   std::size_t dropped);

}  // namespace pliant
