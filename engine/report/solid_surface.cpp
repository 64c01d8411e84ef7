#include "engine/report/solid_surface.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "engine/geometry/signed_distance.hpp"

namespace pliant::report {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int cells = 48;         // along the longest side of the box
constexpr double flatness = 0.1;  // smaller eigenvalues, over the largest, belong to one face

Vector array_of(const Vector3d& x) { return {x[0], x[1], x[2]}; }

/// A point of the surface and its outward normal.
struct SurfacePoint {
  Vector3d place, normal;
};

/// Depth below the surface of a solid cut off at the end of a box [m]: negative inside.
class ClippedSolid {
 public:
  ClippedSolid(const Shape& solid, const Box<3>& box) : solid_(solid), box_(box) {}

  double operator()(const Vector3d& x) const {
    return std::max(signed_distance(solid_, array_of(x), 3), beyond_box(x).first);
  }

  Vector3d normal(const Vector3d& x) const {
    const auto [distance, side] = beyond_box(x);
    if (distance > signed_distance(solid_, array_of(x), 3)) return side;
    return Vector3d(outward_direction(solid_, array_of(x), 3).data());
  }

 private:
  /// Distance from the nearest side of the box, and the normal of that side.
  std::pair<double, Vector3d> beyond_box(const Vector3d& x) const {
    std::pair<double, Vector3d> farthest = {-INFINITY, Vector3d::Zero()};
    for (int a = 0; a < 3; ++a) {
      const double below = box_.lower[a] - x[a], above = x[a] - box_.upper[a];
      const double distance = std::max(below, above);
      if (distance <= farthest.first) continue;
      farthest = {distance, Vector3d::Unit(a) * (above > below ? 1 : -1)};
    }
    return farthest;
  }

  const Shape& solid_;
  const Box<3>& box_;
};

/// Where the line from `a` to `b`, on different sides of the surface, crosses it: false position,
/// with half the depth of an end that stays twice in a row (Illinois method).
Vector3d crossing(const ClippedSolid& depth, Vector3d a, Vector3d b, double depth_a,
                  double depth_b) {
  constexpr int refinements = 4;
  Vector3d x = a;
  int last = 0;  // the end that moved last: -1 a, 1 b
  for (int i = 0; i <= refinements; ++i) {
    x = a + depth_a / (depth_a - depth_b) * (b - a);
    const double depth_x = depth(x);
    if ((depth_x < 0) == (depth_a < 0)) {
      if (last == -1) depth_b /= 2;
      a = x, depth_a = depth_x, last = -1;
    } else {
      if (last == 1) depth_a /= 2;
      b = x, depth_b = depth_x, last = 1;
    }
  }
  return x;
}

/// The tangent planes in a cell, and the point with the least squared distance from them.
class TangentPlanes {
 public:
  void add(const SurfacePoint& point) {
    sum_ += point.place;
    planes_ += point.normal * point.normal.transpose();
    offsets_ += point.normal * point.normal.dot(point.place);
    ++count_;
  }

  /// Along directions that the planes leave open, the point is the mean of theirs.
  Vector3d meeting_point() const {
    const Vector3d mean = sum_ / count_;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(planes_);
    const Vector3d residual = offsets_ - planes_ * mean;
    Vector3d x = mean;
    for (int k = 0; k < 3; ++k) {
      if (axes.eigenvalues()[k] < flatness * axes.eigenvalues()[2]) continue;
      const Vector3d axis = axes.eigenvectors().col(k);
      x += axis.dot(residual) / axes.eigenvalues()[k] * axis;
    }
    return x;
  }

 private:
  Vector3d sum_ = Vector3d::Zero(), offsets_ = Vector3d::Zero();
  Matrix3d planes_ = Matrix3d::Zero();
  int count_ = 0;
};

/// The lattice has two more nodes than cells that the box needs along each axis, so that all edges
/// that cross the surface lie between four cells.
class DualContours {
 public:
  DualContours(const Shape& solid, const Box<3>& box) : solid_(solid, box) {
    step_ = longest_side(box) / cells;
    for (int a = 0; a < 3; ++a) {
      nodes_[a] = static_cast<int>(std::ceil((box.upper[a] - box.lower[a]) / step_)) + 3;
      origin_[a] = box.lower[a] - step_;
    }
    depth_.reserve(static_cast<std::size_t>(nodes_[0]) * nodes_[1] * nodes_[2]);
    for (int k = 0; k < nodes_[2]; ++k) {
      for (int j = 0; j < nodes_[1]; ++j) {
        for (int i = 0; i < nodes_[0]; ++i) depth_.push_back(solid_(place_of({i, j, k})));
      }
    }
  }

  TriangleMesh mesh() {
    for (int k = 1; k + 1 < nodes_[2]; ++k) {
      for (int j = 1; j + 1 < nodes_[1]; ++j) {
        for (int i = 1; i + 1 < nodes_[0]; ++i) cross_edges_of({i, j, k});
      }
    }
    for (const Edge& edge : crossed_) add_quadrilateral(edge);
    return std::move(mesh_);
  }

 private:
  using Node = std::array<int, 3>;

  /// From a node to the next one along an axis.
  struct Edge {
    Node node;
    int axis;
    bool is_inside;  ///< the first node
  };

  Vector3d place_of(const Node& node) const {
    return origin_ + step_ * Vector3d(node[0], node[1], node[2]);
  }

  std::size_t number_of(const Node& node) const {
    return (static_cast<std::size_t>(node[2]) * nodes_[1] + node[1]) * nodes_[0] + node[0];
  }

  /// The cells around an edge by their lowest nodes, anticlockwise as seen from its end.
  static std::array<Node, 4> cells_around(const Edge& edge) {
    const int u = (edge.axis + 1) % 3, v = (edge.axis + 2) % 3;
    std::array<Node, 4> around;
    around.fill(edge.node);
    --around[0][u], --around[0][v], --around[1][v], --around[3][u];
    return around;
  }

  void cross_edges_of(const Node& node) {
    const double depth = depth_[number_of(node)];
    for (int axis = 0; axis < 3; ++axis) {
      Node next = node;
      ++next[axis];
      const double depth_next = depth_[number_of(next)];
      if ((depth < 0) == (depth_next < 0)) continue;
      crossed_.push_back({node, axis, depth < 0});
      const Vector3d x = crossing(solid_, place_of(node), place_of(next), depth, depth_next);
      const SurfacePoint point = {x, solid_.normal(x)};
      for (const Node& cell : cells_around(crossed_.back())) planes_[number_of(cell)].add(point);
    }
  }

  std::uint32_t vertex_of(const Node& cell) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertex.size());
    const auto [at, is_new] = vertices_.insert({number_of(cell), next});
    if (is_new) {
      const Vector3d low = place_of(cell), high = low + Vector3d::Constant(step_);
      const Vector3d x = planes_.at(number_of(cell)).meeting_point();
      mesh_.vertex.push_back(array_of(x.cwiseMax(low).cwiseMin(high)));
    }
    return at->second;
  }

  double error_between(std::uint32_t a, std::uint32_t b) const {
    const Vector3d x(mesh_.vertex[a].data()), y(mesh_.vertex[b].data());
    return std::abs(solid_((x + y) / 2));
  }

  /// Its diagonal is the one that lies nearer to the surface.
  void add_quadrilateral(const Edge& edge) {
    std::array<std::uint32_t, 4> corner;
    std::ranges::transform(cells_around(edge), corner.begin(),
                           [&](const Node& cell) { return vertex_of(cell); });
    if (!edge.is_inside) std::ranges::reverse(corner);
    const auto [a, b, c, d] = corner;
    if (error_between(a, c) <= error_between(b, d)) {
      mesh_.triangle.insert(mesh_.triangle.end(), {a, b, c, a, c, d});
    } else {
      mesh_.triangle.insert(mesh_.triangle.end(), {b, c, d, b, d, a});
    }
  }

  ClippedSolid solid_;
  double step_;
  Vector3d origin_;
  Node nodes_ = {};
  std::vector<double> depth_;
  std::vector<Edge> crossed_;
  std::unordered_map<std::size_t, TangentPlanes> planes_;  ///< of cells by their numbers
  std::unordered_map<std::size_t, std::uint32_t> vertices_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh surface_of_solid(const Shape& solid, const Box<3>& box) {
  return DualContours(solid, box).mesh();
}

double longest_side(const Box<3>& box) {
  double side = 0;
  for (int a = 0; a < 3; ++a) side = std::max(side, box.upper[a] - box.lower[a]);
  return side;
}

}  // namespace pliant::report
