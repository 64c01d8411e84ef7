#include "engine/geometry/closed_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/BVH>
#include <utility>

#include "engine/geometry/mesh_topology.hpp"
#include "engine/geometry/triangle_foot.hpp"

namespace pliant {
namespace {

using Vector3 = Eigen::Vector3d;

Vector3 point(const Vector& v) { return {v[0], v[1], v[2]}; }
Vector vector(const Vector3& p) { return {p[0], p[1], p[2]}; }

using Corners = std::array<Vector3, 3>;

Corners corners_of(const SurfaceMesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {point(mesh.vertices[t[0]]), point(mesh.vertices[t[1]]), point(mesh.vertices[t[2]])};
}

Vector3 unit_normal(const Corners& c) { return (c[1] - c[0]).cross(c[2] - c[0]).normalized(); }

using BoxTree = Eigen::KdBVH<double, 3, int>;

/// Finds the triangle nearest to `x`, nearer boxes first.
struct Search {
  const SurfaceMesh& mesh;
  const BoxTree& tree;
  Vector3 x;
  double best = std::numeric_limits<double>::infinity();  // squared distance
  int triangle = -1;
  TriangleFoot foot = {};

  void compare(int candidate) {
    const TriangleFoot there = foot_on_triangle(corners_of(mesh, candidate), x);
    const double square = (there.place - x).squaredNorm();
    if (square >= best) return;
    best = square;
    triangle = candidate;
    foot = there;
  }

  void descend(int node) {
    const int *boxes = nullptr, *boxes_end = nullptr, *triangles = nullptr,
              *triangles_end = nullptr;
    tree.getChildren(node, boxes, boxes_end, triangles, triangles_end);
    for (; triangles != triangles_end; ++triangles) compare(*triangles);
    std::array<std::pair<double, int>, 2> inner;
    std::size_t count = 0;
    for (; boxes != boxes_end; ++boxes) {
      inner[count++] = {tree.getVolume(*boxes).squaredExteriorDistance(x), *boxes};
    }
    if (count == 2 && inner[1].first < inner[0].first) std::swap(inner[0], inner[1]);
    for (std::size_t i = 0; i < count; ++i) {
      if (inner[i].first < best) descend(inner[i].second);
    }
  }
};

double enclosed_volume(const SurfaceMesh& mesh) {
  const Vector3 origin = point(mesh.vertices.front());
  double six_volumes = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners_of(mesh, t);
    six_volumes += (c[0] - origin).dot((c[1] - origin).cross(c[2] - origin));
  }
  return six_volumes / 6;
}

double angle_at(const Corners& c, int k) {
  const Vector3 a = c[(k + 1) % 3] - c[k], b = c[(k + 2) % 3] - c[k];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

struct ClosedMesh::Tree {
  BoxTree boxes;
};

ClosedMesh::ClosedMesh(SurfaceMesh mesh, const std::string& name) : mesh_(std::move(mesh)) {
  join_vertices(mesh_);
  dropped_ = drop_degenerate(mesh_);
  if (mesh_.triangles.empty()) {
    throw MeshError(fmt::format("{}: no triangle has an area", name),
                    "export the surface with its faces");
  }
  volume_ = enclosed_volume(mesh_);
  if (volume_ < 0) {
    for (Triangle& t : mesh_.triangles) std::swap(t[1], t[2]);
    volume_ = -volume_;
  }
  find_pseudonormals(paired_edges(mesh_, name, dropped_));
  Eigen::AlignedBox3d whole;
  std::vector<int> triangles;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    triangles.push_back(static_cast<int>(t));
    Eigen::AlignedBox3d& box = boxes.emplace_back();
    for (const Vector3& corner : corners_of(mesh_, t)) box.extend(corner);
    whole.extend(box);
  }
  bounds_ = {vector(whole.min()), vector(whole.max())};
  tree_ = std::make_unique<Tree>();
  tree_->boxes.init(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
}

ClosedMesh::~ClosedMesh() = default;

void ClosedMesh::find_pseudonormals(const std::vector<HalfEdge>& edges) {
  std::vector<Vector3> at_vertex(mesh_.vertices.size(), Vector3::Zero());
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Corners c = corners_of(mesh_, t);
    const Vector3 normal = unit_normal(c);
    for (int k = 0; k < 3; ++k) at_vertex[mesh_.triangles[t][k]] += angle_at(c, k) * normal;
  }
  for (const Vector3& normal : at_vertex) vertex_normals_.push_back(vector(normal));
  edge_normals_.resize(mesh_.triangles.size());
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    const HalfEdge &a = edges[e], &b = edges[e + 1];
    const Vector3 sum =
        unit_normal(corners_of(mesh_, a.triangle)) + unit_normal(corners_of(mesh_, b.triangle));
    edge_normals_[a.triangle][a.corner] = edge_normals_[b.triangle][b.corner] = vector(sum);
  }
}

ClosedMesh::Nearest ClosedMesh::nearest(const Vector& x) const {
  Search search{mesh_, tree_->boxes, point(x)};
  search.descend(tree_->boxes.getRootIndex());
  Vector3 normal;
  switch (search.foot.part) {
    case TriangleFoot::Part::face:
      normal = unit_normal(corners_of(mesh_, search.triangle));
      break;
    case TriangleFoot::Part::edge:
      normal = point(edge_normals_[search.triangle][search.foot.corner]);
      break;
    case TriangleFoot::Part::corner:
      normal = point(vertex_normals_[mesh_.triangles[search.triangle][search.foot.corner]]);
  }
  const Vector3 offset = search.x - search.foot.place;
  const double distance = offset.norm();
  const double sign = offset.dot(normal) < 0 ? -1 : 1;
  // On the surface itself, the direction of the offset is only rounding.
  const bool on_surface = distance <= 1e-14 * search.x.norm() || distance == 0;
  const Vector3 direction = on_surface ? normal.normalized() : Vector3(sign / distance * offset);
  return {sign * distance, vector(direction)};
}

}  // namespace pliant
