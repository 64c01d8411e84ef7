#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/geometry/surface_mesh.hpp"

namespace pliant {

struct HalfEdge;

/// A closed surface of triangles and the distances to it.
///
/// The distance is that to the nearest point of the nearest triangle, found through a tree of
/// boxes. Its sign is that of the angle-weighted pseudonormal there: the nearest point may lie on
/// an edge or a corner, where the normal of one of the triangles that meet there may point the
/// wrong way, but their sum, weighted by their angles at a corner, never does.
///
///        \   x         x is outside and nearest to the corner; the triangle below it to the left
///      ___\.           sees it from behind, both together do not.
///
/// J. A. Baerentzen, H. Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243-253.
class ClosedMesh {
 public:
  /// Joins vertices at equal places, drops triangles without area and turns the surface inside out
  /// when it faces inwards. Throws MeshError, which calls the mesh `name`, when the surface has
  /// open edges, edges of more than two triangles, or triangles that face different ways.
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
  std::size_t dropped() const { return dropped_; }  ///< triangles without area, of the file
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
