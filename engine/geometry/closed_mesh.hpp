#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/geometry/surface_mesh.hpp"

namespace pliant {

struct HalfEdge;

/// A closed surface of triangles, and distances to it.
///
/// The distance is that to the nearest point of the nearest triangle, found with a tree of boxes.
/// Its sign comes from the angle-weighted pseudonormal there. The nearest point may be on an edge
/// or a corner, where the normal of a single triangle may point the wrong way, but the sum of the
/// normals, weighted by their angles at a corner, never does.
///
///        \   x         x is outside and nearest to the corner. The triangle at the lower left
///      ___\.           faces away from it, but the sum of both normals points towards it.
///
/// J. A. Baerentzen, H. Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243-253.
class ClosedMesh {
 public:
  /// Joins vertices at equal places, drops triangles without area, and flips the surface if it
  /// faces inwards. Throws MeshError, which calls the mesh `name`, if the surface has open edges,
  /// edges of more than two triangles, or inconsistently oriented triangles.
  ClosedMesh(SurfaceMesh mesh, const std::string& name);
  ~ClosedMesh();
  ClosedMesh(const ClosedMesh&) = delete;
  ClosedMesh& operator=(const ClosedMesh&) = delete;

  struct Nearest {
    double distance;   ///< [m], negative inside
    Vector direction;  ///< unit vector along which it grows
  };
  Nearest nearest(const Vector& x) const;

  const std::vector<Vector>& vertices() const { return mesh_.vertices; }
  const std::vector<Triangle>& triangles() const { return mesh_.triangles; }
  std::size_t elements() const { return mesh_.elements; }  ///< of the file, if of tetrahedra; or 0
  std::size_t dropped() const { return dropped_; }         ///< triangles of the file without area
  const Box<3>& bounds() const { return bounds_; }
  double volume() const { return volume_; }  ///< [m^3]

 private:
  struct Tree;

  void find_pseudonormals(const std::vector<HalfEdge>& edges);

  SurfaceMesh mesh_;
  std::size_t dropped_ = 0;
  Box<3> bounds_ = {};
  double volume_ = 0;
  std::vector<std::array<Vector, 3>> edge_normals_;  ///< [triangle][edge after corner]
  std::vector<Vector> vertex_normals_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace pliant
