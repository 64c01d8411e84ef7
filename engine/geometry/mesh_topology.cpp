#include "engine/geometry/mesh_topology.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>
#include <tuple>

namespace pliant {
namespace {

using VertexMap = Eigen::Map<const Eigen::Vector3d>;

bool has_area(const SurfaceMesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
  const VertexMap a(mesh.vertices[t[0]].data()), b(mesh.vertices[t[1]].data()),
      c(mesh.vertices[t[2]].data());
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
  return ab.cross(ac).norm() > 1e-14 * longest;
}

std::vector<HalfEdge> sorted_edges(const SurfaceMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
      edges.push_back(
          {std::min(from, to), std::max(from, to), from < to, static_cast<std::int32_t>(t), k});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return edges;
}

/// Edges of a kind that closed surfaces do not have.
struct Fault {
  std::size_t count = 0;
  Vector middle = {};  // of the first of them

  void add(const SurfaceMesh& mesh, const HalfEdge& edge) {
    if (++count > 1) return;
    for (int i = 0; i < 3; ++i) {
      middle[i] = (mesh.vertices[edge.low][i] + mesh.vertices[edge.high][i]) / 2;
    }
  }

  void refuse(const std::string& name, std::string_view what, std::string_view remedy,
              std::size_t dropped) const {
    if (count == 0) return;
    const std::string without =
        dropped == 0 ? "" : fmt::format(" without {} triangles of no area", dropped);
    throw MeshError(fmt::format("{}: {}{}: {}, the first near ({:.6g}, {:.6g}, {:.6g})", name, what,
                                without, count, middle[0], middle[1], middle[2]),
                    std::string(remedy));
  }
};

}  // namespace

void join_vertices(SurfaceMesh& mesh) {
  for (Vector& vertex : mesh.vertices) {
    for (double& component : vertex) component += 0.0;  // -0 becomes 0
  }
  std::vector<std::int32_t> order;
  std::vector<bool> used(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::int32_t v : t) used[v] = true;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) order.push_back(static_cast<std::int32_t>(v));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return mesh.vertices[a] < mesh.vertices[b];
  });
  std::vector<std::int32_t> joined(mesh.vertices.size());
  std::vector<Vector> vertices;
  for (const std::int32_t v : order) {
    if (vertices.empty() || vertices.back() != mesh.vertices[v]) {
      vertices.push_back(mesh.vertices[v]);
    }
    joined[v] = static_cast<std::int32_t>(vertices.size()) - 1;
  }
  mesh.vertices = std::move(vertices);
  for (Triangle& t : mesh.triangles) {
    for (std::int32_t& v : t) v = joined[v];
  }
}

std::size_t drop_degenerate(SurfaceMesh& mesh) {
  return std::erase_if(mesh.triangles, [&](const Triangle& t) { return !has_area(mesh, t); });
}

std::vector<HalfEdge> paired_edges(const SurfaceMesh& mesh, const std::string& name,
                                   std::size_t dropped) {
  std::vector<HalfEdge> edges = sorted_edges(mesh);
  Fault open, crowded, turned;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    const HalfEdge& edge = edges[first];
    while (last < edges.size() && edges[last].low == edge.low && edges[last].high == edge.high) {
      ++last;
    }
    if (last - first == 1) {
      open.add(mesh, edge);
    } else if (last - first > 2) {
      crowded.add(mesh, edge);
    } else if (edge.forward == edges[first + 1].forward) {
      turned.add(mesh, edge);
    }
  }
  open.refuse(name, "open edges", "close the surface, and give points that touch the same place",
              dropped);
  crowded.refuse(name, "edges of more than two triangles",
                 "remove double and inner triangles, so that the surface has one inside", dropped);
  turned.refuse(name, "edges between triangles that face different ways",
                "orient all faces outwards", dropped);
  return edges;
}

}  // namespace pliant
