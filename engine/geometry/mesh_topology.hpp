#pragma once

#include <string>
#include <vector>

#include "engine/geometry/surface_mesh.hpp"

/// Connectivity of the triangles of a mesh.
namespace pliant {

/// Joins vertices at equal places and drops vertices without triangles.
void join_vertices(SurfaceMesh& mesh);

/// Removes triangles whose corners coincide or are collinear. Returns their number.
std::size_t drop_degenerate(SurfaceMesh& mesh);

/// The edge that starts at a corner of a triangle.
struct HalfEdge {
  std::int32_t low, high;  ///< its vertices
  bool forward;            ///< whether it runs from `low` to `high`
  std::int32_t triangle;
  int corner;
};

/// The half-edges of a closed surface; those of each edge are adjacent, one forward and one
/// backward. Otherwise throws MeshError, which calls the mesh `name`, with the number of other
/// edges and the place of the first.
std::vector<HalfEdge> paired_edges(const SurfaceMesh& mesh, const std::string& name,
                                   std::size_t dropped);

}  // namespace pliant
