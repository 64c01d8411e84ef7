#include "engine/geometry/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/geometry/continued_mesh.hpp"

namespace pliant {
namespace {

/// One face of a box: across `axis`, at its lower or upper end.
struct Face {
  int axis;
  bool upper;

  double& end_of(Shape& box) const { return upper ? box.upper[axis] : box.lower[axis]; }
  double position(const Shape& box) const { return upper ? box.upper[axis] : box.lower[axis]; }
  double opposite(const Shape& box) const { return upper ? box.lower[axis] : box.upper[axis]; }
  /// How far this face of `box` is behind a plane across the axis that looks the other way.
  double depth_behind(double plane, const Shape& box) const {
    return upper ? position(box) - plane : plane - position(box);
  }
};

/// Walls in front of a body, and how far from one a face may be that lies against it [m].
struct Walls {
  std::span<const Shape> shapes;
  double gap;

  /// Whether a face that is at `depth` behind that of a wall lies against it. The same plane,
  /// written in decimals in two places of a case file, agrees only up to rounding.
  bool hold(double depth, double size) const { return depth >= -std::max(gap, 1e-9 * size); }
};

double size_of(const Shape& box, int dimension) {
  double size = 0;
  for (int i = 0; i < dimension; ++i) {
    const double extent = box.upper[i] - box.lower[i];
    if (std::isfinite(extent)) size = std::max(size, extent);
  }
  return size;
}

/// The part of `body` in front of `wall` across `face`, as a box that continues through the wall;
/// none if the wall is not there.
std::optional<Shape> continued(const Shape& body, const Face& face, const Shape& wall,
                               const Walls& walls, int dimension) {
  const double size = size_of(body, dimension);
  Shape part = body;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  face.end_of(part) = face.upper ? infinity : -infinity;
  if (wall.kind == Shape::Kind::half_space) {
    const bool faces_body = wall.normal[face.axis] == (face.upper ? -1 : 1);
    const double depth = face.depth_behind(wall.point[face.axis], body);
    const bool touches =
        walls.hold(depth, size) && depth < body.upper[face.axis] - body.lower[face.axis];
    return faces_body && touches ? std::optional(part) : std::nullopt;
  }
  if (wall.kind != Shape::Kind::box) return std::nullopt;
  const double depth = face.depth_behind(face.opposite(wall), body);
  const double thickness = wall.upper[face.axis] - wall.lower[face.axis];
  if (!walls.hold(depth, size) || depth >= thickness) return std::nullopt;
  for (int i = 0; i < dimension; ++i) {
    if (i == face.axis) continue;
    if (wall.lower[i] > body.lower[i] + 1e-9 * size) part.lower[i] = wall.lower[i];
    if (wall.upper[i] < body.upper[i] - 1e-9 * size) part.upper[i] = wall.upper[i];
    if (part.lower[i] >= part.upper[i]) return std::nullopt;
  }
  return part;
}

bool covers_face(const Shape& part, const Shape& body, const Face& face, int dimension) {
  for (int i = 0; i < dimension; ++i) {
    if (i == face.axis) continue;
    if (part.lower[i] != body.lower[i] || part.upper[i] != body.upper[i]) return false;
  }
  return true;
}

Shape open_box(const Shape& body, const Walls& walls, int dimension) {
  Shape open = body;
  std::vector<Shape> parts;
  for (int axis = 0; axis < dimension; ++axis) {
    for (const bool upper : {false, true}) {
      const Face face{axis, upper};
      for (const Shape& wall : walls.shapes) {
        const std::optional<Shape> part = continued(body, face, wall, walls, dimension);
        if (!part) continue;
        if (covers_face(*part, body, face, dimension)) {
          face.end_of(open) = face.position(*part);
        } else {
          parts.push_back(*part);
        }
      }
    }
  }
  if (parts.empty()) return open;
  parts.insert(parts.begin(), open);
  Shape united;
  united.kind = Shape::Kind::unite;
  united.operands = std::move(parts);
  return united;
}

/// Whether `wall` is at the plane side of a body that a half-space cuts: the body is in the
/// half-space (`inside`) or next to it.
bool stands_at(const Shape& wall, const Shape& half_space, bool inside, const Walls& walls) {
  if (wall.kind != Shape::Kind::half_space || half_space.kind != Shape::Kind::half_space) {
    return false;
  }
  double turned = 0, depth = 0, size = 0;
  for (int a = 0; a < 3; ++a) {
    const double along = (inside ? -1 : 1) * half_space.normal[a];
    turned = std::max(turned, std::abs(wall.normal[a] - along));
    depth -= along * (half_space.point[a] - wall.point[a]);
    size = std::max({size, std::abs(wall.point[a]), std::abs(half_space.point[a])});
  }
  return turned <= 1e-9 && walls.hold(depth, size);
}

/// `body` without the half-spaces that cut it at walls.
Shape uncut(const Shape& body, const Walls& walls) {
  using enum Shape::Kind;
  if (body.kind != intersect && body.kind != subtract) return body;
  Shape open = body;
  const bool inside = body.kind == intersect;
  open.operands.erase(std::remove_if(open.operands.begin() + (inside ? 0 : 1), open.operands.end(),
                                     [&](const Shape& part) {
                                       return std::ranges::any_of(
                                           walls.shapes, [&](const Shape& wall) {
                                             return stands_at(wall, part, inside, walls);
                                           });
                                     }),
                      open.operands.end());
  if (open.operands.empty()) return body;
  return open.operands.size() == 1 ? open.operands.front() : open;
}

Shape open_mesh(const Shape& body, const Walls& walls) {
  Shape open = body;
  for (const Shape& wall : walls.shapes) {
    if (auto continued = continued_through(*open.mesh, wall, walls.gap)) {
      open.mesh = std::move(continued);
    }
  }
  return open;
}

Shape open_at(const Shape& body, const Walls& walls, int dimension) {
  if (body.kind == Shape::Kind::box) return open_box(body, walls, dimension);
  if (body.kind == Shape::Kind::mesh) return open_mesh(body, walls);
  Shape open = uncut(body, walls);
  if (open.kind == Shape::Kind::box) return open_box(open, walls, dimension);
  for (Shape& operand : open.operands) operand = open_at(operand, walls, dimension);
  return open;
}

}  // namespace

Shape free_surface(const Shape& body, std::span<const Shape> walls, int dimension, double gap) {
  return open_at(body, {walls, gap}, dimension);
}

}  // namespace pliant
