#include "engine/geometry/continued_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "engine/geometry/mesh_topology.hpp"

namespace pliant {
namespace {

// Binary STL files and many exporters have 7 digits.
constexpr double rounding = 1e-6;

/// A plane and its unit normal, from the wall to the body.
struct Plane {
  Vector point;
  Vector normal;

  double height(const Vector& x) const {
    double sum = 0;
    for (int a = 0; a < 3; ++a) sum += (x[a] - point[a]) * normal[a];
    return sum;
  }
};

double size_of(const Box<3>& box) {
  double size = 0;
  for (int a = 0; a < 3; ++a) size = std::max(size, box.upper[a] - box.lower[a]);
  return size;
}

/// Height of the lowest vertex over a plane [m].
double lowest(const ClosedMesh& mesh, const Plane& plane) {
  double height = std::numeric_limits<double>::infinity();
  for (const Vector& x : mesh.vertices()) height = std::min(height, plane.height(x));
  return height;
}

/// The face of `wall` on which the mesh stands: of a box, that which is the least inside the mesh.
std::optional<Plane> face_below(const ClosedMesh& mesh, const Shape& wall) {
  if (wall.kind == Shape::Kind::half_space) return Plane{wall.point, wall.normal};
  std::optional<Plane> face;
  if (wall.kind != Shape::Kind::box) return face;
  double highest = -std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const double end = upper ? wall.upper[axis] : wall.lower[axis];
      if (!std::isfinite(end)) continue;
      Plane plane{{}, {}};
      plane.point[axis] = end;
      plane.normal[axis] = upper ? 1 : -1;
      const double height = lowest(mesh, plane);
      if (height <= highest) continue;
      highest = height;
      face = plane;
    }
  }
  return face;
}

/// Whether a box extends as far as `x` along all axes; true for half-spaces.
bool covers(const Shape& wall, const Vector& x, double tolerance) {
  if (wall.kind != Shape::Kind::box) return true;
  for (int a = 0; a < 3; ++a) {
    if (x[a] < wall.lower[a] - tolerance || x[a] > wall.upper[a] + tolerance) return false;
  }
  return true;
}

/// The vertices and triangles of a mesh that are in a plane.
struct FlatSide {
  std::vector<char> vertex, triangle;

  FlatSide(const ClosedMesh& mesh, const Plane& plane, double tolerance) {
    for (const Vector& x : mesh.vertices()) {
      vertex.push_back(std::abs(plane.height(x)) <= tolerance ? 1 : 0);
    }
    for (const Triangle& t : mesh.triangles()) {
      triangle.push_back(std::ranges::all_of(t, [&](int v) { return vertex[v] != 0; }) ? 1 : 0);
    }
  }

  bool is_empty() const { return std::ranges::find(triangle, 1) == triangle.end(); }

  bool is_covered(const ClosedMesh& mesh, const Shape& wall, double tolerance) const {
    for (std::size_t t = 0; t < triangle.size(); ++t) {
      if (triangle[t] == 0) continue;
      for (const int v : mesh.triangles()[t]) {
        if (!covers(wall, mesh.vertices()[v], tolerance)) return false;
      }
    }
    return true;
  }

  /// Whether other edges are in the plane of the side: mirror images would meet there too.
  bool has_loose_edges(const SurfaceMesh& mesh) const {
    const std::vector<HalfEdge> edges = paired_edges(mesh, "mesh", 0);
    for (std::size_t e = 0; e < edges.size(); e += 2) {
      if (vertex[edges[e].low] == 0 || vertex[edges[e].high] == 0) continue;
      if (triangle[edges[e].triangle] == 0 && triangle[edges[e + 1].triangle] == 0) return true;
    }
    return false;
  }
};

Vector mirrored(const Vector& x, const Plane& plane) {
  Vector image = x;
  const double height = plane.height(x);
  for (int a = 0; a < 3; ++a) image[a] -= 2 * height * plane.normal[a];
  return image;
}

}  // namespace

std::shared_ptr<const ClosedMesh> continued_through(const ClosedMesh& mesh, const Shape& wall,
                                                    double gap) {
  const double tolerance = rounding * size_of(mesh.bounds()), farthest = std::max(gap, tolerance);
  std::optional<Plane> plane = face_below(mesh, wall);
  if (!plane) return nullptr;
  const double height = lowest(mesh, *plane);
  if (height > farthest) return nullptr;
  for (int a = 0; a < 3; ++a) plane->point[a] += height * plane->normal[a];
  const FlatSide side(mesh, *plane, tolerance);
  const SurfaceMesh whole{mesh.vertices(), mesh.triangles()};
  if (side.is_empty() || !side.is_covered(mesh, wall, farthest) || side.has_loose_edges(whole)) {
    return nullptr;
  }
  SurfaceMesh joined{whole.vertices, {}};
  std::vector<std::int32_t> image;
  for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
    image.push_back(static_cast<std::int32_t>(side.vertex[v] != 0 ? v : joined.vertices.size()));
    if (side.vertex[v] == 0) joined.vertices.push_back(mirrored(whole.vertices[v], *plane));
  }
  for (std::size_t k = 0; k < whole.triangles.size(); ++k) {
    if (side.triangle[k] != 0) continue;
    const Triangle& t = whole.triangles[k];
    joined.triangles.push_back(t);
    joined.triangles.push_back({image[t[0]], image[t[2]], image[t[1]]});
  }
  return std::make_shared<const ClosedMesh>(std::move(joined), "mesh");
}

}  // namespace pliant
