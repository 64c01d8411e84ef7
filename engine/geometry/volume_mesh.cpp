#include "engine/geometry/volume_mesh.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace pliant {
namespace {

using VertexMap = Eigen::Map<const Eigen::Vector3d>;

/// The facets of a tetrahedron, ordered as seen from outside.
constexpr int facets[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

}  // namespace

double element_volume(const VolumeMesh& mesh, std::size_t e) {
  const auto& corners = mesh.elements[e];
  const Eigen::Vector3d a = VertexMap(mesh.vertices[corners[0]].data());
  const Eigen::Vector3d ab = VertexMap(mesh.vertices[corners[1]].data()) - a;
  const Eigen::Vector3d ac = VertexMap(mesh.vertices[corners[2]].data()) - a;
  if (mesh.dimension == 2) return ab.cross(ac).z() / 2;
  return ab.cross(ac).dot(VertexMap(mesh.vertices[corners[3]].data()) - a) / 6;
}

SurfaceMesh boundary_of(const VolumeMesh& mesh) {
  struct Facet {
    std::array<std::int32_t, 3> sorted;
    Triangle triangle;
  };
  std::vector<Facet> all;
  all.reserve(4 * mesh.elements.size());
  for (const auto& corners : mesh.elements) {
    for (const auto& facet : facets) {
      const Triangle triangle = {corners[facet[0]], corners[facet[1]], corners[facet[2]]};
      Facet& added = all.emplace_back(Facet{triangle, triangle});
      std::sort(added.sorted.begin(), added.sorted.end());
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Facet& a, const Facet& b) { return a.sorted < b.sorted; });
  SurfaceMesh surface{mesh.vertices, {}, mesh.elements.size()};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i + 1 < all.size() && all[i].sorted == all[i + 1].sorted) {
      ++i;
    } else {
      surface.triangles.push_back(all[i].triangle);
    }
  }
  return surface;
}

}  // namespace pliant
