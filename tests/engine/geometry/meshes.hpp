#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "engine/geometry/closed_mesh.hpp"

namespace pliant::tests {

/// A box of twelve triangles.
inline SurfaceMesh box_mesh(const Vector& lower, const Vector& upper) {
  SurfaceMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    Vector& v = mesh.vertices.emplace_back();
    for (int i = 0; i < 3; ++i) v[i] = corner >> i & 1 ? upper[i] : lower[i];
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A sphere about the origin: an octahedron whose triangles are divided in four repeatedly.
inline SurfaceMesh sphere_mesh(double radius, int divisions) {
  SurfaceMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int k = 0; k < divisions; ++k) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, added] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (added) {
        Vector v;
        for (int i = 0; i < 3; ++i) v[i] = mesh.vertices[a][i] + mesh.vertices[b][i];
        const double length = std::hypot(v[0], v[1], v[2]);
        mesh.vertices.push_back({v[0] / length, v[1] / length, v[2] / length});
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      for (const Triangle& part :
           {Triangle{t[0], a, c}, Triangle{a, t[1], b}, Triangle{c, b, t[2]}, Triangle{a, b, c}}) {
        finer.push_back(part);
      }
    }
    mesh.triangles = std::move(finer);
  }
  for (Vector& v : mesh.vertices) {
    for (double& component : v) component *= radius;
  }
  return mesh;
}

inline Shape mesh_shape(SurfaceMesh mesh) {
  Shape shape;
  shape.kind = Shape::Kind::mesh;
  shape.mesh = std::make_shared<const ClosedMesh>(std::move(mesh), "mesh");
  return shape;
}

}  // namespace pliant::tests
