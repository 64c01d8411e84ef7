#include "engine/geometry/signed_distance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "engine/geometry/closed_mesh.hpp"

namespace pliant {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double dot(const Vector& a, const Vector& b, int dimension) {
  double sum = 0;
  for (int i = 0; i < dimension; ++i) sum += a[i] * b[i];
  return sum;
}

double length(const Vector& a, int dimension) { return std::sqrt(dot(a, a, dimension)); }

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// A distance and the direction in which it grows.
struct Nearest {
  double distance;
  Vector direction;
};

Nearest nearest(const Shape& shape, const Vector& x, int dimension);

/// Distance of `x` beyond the nearer of the two faces across `axis`; negative between them.
Nearest beyond_slab(const Shape& box, const Vector& x, int axis) {
  Nearest slab{std::max(box.lower[axis] - x[axis], x[axis] - box.upper[axis]), {}};
  slab.direction[axis] = box.lower[axis] - x[axis] > x[axis] - box.upper[axis] ? -1 : 1;
  return slab;
}

Nearest nearest_box(const Shape& box, const Vector& x, int dimension) {
  Nearest inside{-infinity, {1, 0, 0}};
  Nearest outside{0, {}};
  for (int axis = 0; axis < dimension; ++axis) {
    const Nearest slab = beyond_slab(box, x, axis);
    if (slab.distance > inside.distance) inside = slab;
    if (slab.distance > 0) outside.direction[axis] = slab.distance * slab.direction[axis];
  }
  outside.distance = length(outside.direction, dimension);
  if (outside.distance == 0) return inside;
  for (double& component : outside.direction) component /= outside.distance;
  return outside;
}

/// A unit vector normal to `axis`, any if `axis` is null: the cross product with the z axis in 2D,
/// with the coordinate direction of its least component in 3D.
Vector across(const Vector& axis, int dimension) {
  const Vector size = {std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])};
  Vector product;
  if (dimension == 2 || (size[2] <= size[0] && size[2] <= size[1])) {
    product = {axis[1], -axis[0], 0};
  } else if (size[0] <= size[1]) {
    product = {0, axis[2], -axis[1]};
  } else {
    product = {-axis[2], 0, axis[0]};
  }
  const double norm = length(product, 3);
  if (norm == 0) return {1, 0, 0};
  return {product[0] / norm, product[1] / norm, product[2] / norm};
}

/// A ball, a capsule or an infinite cylinder, by the offset from the nearest point of its axis. The
/// axis of a ball is null. On the axis all directions across it are equivalent.
Nearest nearest_round(double radius, Vector offset, const Vector& axis, int dimension) {
  const double distance = length(offset, dimension);
  if (distance == 0) return {-radius, across(axis, dimension)};
  for (int i = 0; i < 3; ++i) offset[i] = i < dimension ? offset[i] / distance : 0;
  return {distance - radius, offset};
}

Nearest nearest_cylinder(const Shape& cylinder, const Vector& x, int dimension) {
  Vector offset = minus(x, cylinder.centre);
  const double along = dot(offset, cylinder.axis, dimension);
  for (int i = 0; i < dimension; ++i) offset[i] -= along * cylinder.axis[i];
  return nearest_round(cylinder.radius, offset, cylinder.axis, dimension);
}

Nearest nearest_capsule(const Shape& capsule, const Vector& x, int dimension) {
  const Vector line = minus(capsule.to, capsule.from);
  Vector offset = minus(x, capsule.from);
  const double square = dot(line, line, dimension);
  const double share = square == 0 ? 0 : std::clamp(dot(offset, line, dimension) / square, 0., 1.);
  for (int i = 0; i < dimension; ++i) offset[i] -= share * line[i];
  return nearest_round(capsule.radius, offset, line, dimension);
}

Nearest opposite(Nearest a) {
  a.distance = -a.distance;
  for (double& component : a.direction) component = -component;
  return a;
}

Nearest nearest_combination(const Shape& shape, const Vector& x, int dimension) {
  assert(!shape.operands.empty());
  Nearest result = nearest(shape.operands.front(), x, dimension);
  for (std::size_t i = 1; i < shape.operands.size(); ++i) {
    Nearest other = nearest(shape.operands[i], x, dimension);
    if (shape.kind == Shape::Kind::subtract) other = opposite(other);
    const bool closer = shape.kind == Shape::Kind::unite ? other.distance < result.distance
                                                         : other.distance > result.distance;
    if (closer) result = other;
  }
  return result;
}

Nearest nearest_mesh(const Shape& shape, const Vector& x) {
  const ClosedMesh::Nearest found = shape.mesh->nearest(x);
  return {found.distance, found.direction};
}

double above_plane(const Shape& half_space, const Vector& x, int dimension) {
  return dot(minus(x, half_space.point), half_space.normal, dimension);
}

Nearest nearest(const Shape& shape, const Vector& x, int dimension) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return nearest_box(shape, x, dimension);
    case Shape::Kind::ball:
      return nearest_round(shape.radius, minus(x, shape.centre), {}, dimension);
    case Shape::Kind::capsule:
      return nearest_capsule(shape, x, dimension);
    case Shape::Kind::cylinder:
      return nearest_cylinder(shape, x, dimension);
    case Shape::Kind::half_space:
      return {above_plane(shape, x, dimension), shape.normal};
    case Shape::Kind::mesh:
      return nearest_mesh(shape, x);
    default:
      return nearest_combination(shape, x, dimension);
  }
}

Box<3> everywhere() { return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}}; }

Box<3> around(const Vector& centre, const Vector& reach) {
  Box<3> box{};
  for (int i = 0; i < 3; ++i) {
    box.lower[i] = centre[i] - reach[i];
    box.upper[i] = centre[i] + reach[i];
  }
  return box;
}

/// A half-space is bounded only along an axis that is normal to its surface.
Box<3> half_space_bounds(const Shape& shape) {
  Box<3> box = everywhere();
  for (int i = 0; i < 3; ++i) {
    if (shape.normal[i] == 1) box.upper[i] = shape.point[i];
    if (shape.normal[i] == -1) box.lower[i] = shape.point[i];
  }
  return box;
}

}  // namespace

// Skips the direction for half-spaces: most walls are, and a remeshing queries the distance of
// every slot from every wall.
double signed_distance(const Shape& shape, const Vector& x, int dimension) {
  if (shape.kind == Shape::Kind::half_space) return above_plane(shape, x, dimension);
  return nearest(shape, x, dimension).distance;
}

Vector outward_direction(const Shape& shape, const Vector& x, int dimension) {
  return nearest(shape, x, dimension).direction;
}

Box<3> bounding_box(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return {shape.lower, shape.upper};
    case Shape::Kind::ball:
      return around(shape.centre, {shape.radius, shape.radius, shape.radius});
    case Shape::Kind::capsule: {
      const Vector reach = {shape.radius, shape.radius, shape.radius};
      Box<3> box = around(shape.from, reach);
      box.grow(around(shape.to, reach));
      return box;
    }
    case Shape::Kind::cylinder: {
      Vector reach;
      for (int i = 0; i < 3; ++i) reach[i] = shape.axis[i] == 0 ? shape.radius : infinity;
      return around(shape.centre, reach);
    }
    case Shape::Kind::half_space:
      return half_space_bounds(shape);
    case Shape::Kind::mesh:
      return shape.mesh->bounds();
    case Shape::Kind::subtract:
      return bounding_box(shape.operands.front());
    default:
      break;
  }
  const bool unite = shape.kind == Shape::Kind::unite;
  Box<3> box = bounding_box(shape.operands.front());
  for (std::size_t k = 1; k < shape.operands.size(); ++k) {
    const Box<3> other = bounding_box(shape.operands[k]);
    for (int i = 0; i < 3; ++i) {
      box.lower[i] =
          unite ? std::min(box.lower[i], other.lower[i]) : std::max(box.lower[i], other.lower[i]);
      box.upper[i] =
          unite ? std::max(box.upper[i], other.upper[i]) : std::min(box.upper[i], other.upper[i]);
    }
  }
  return box;
}

bool contains_mesh(const Shape& shape) {
  return shape.kind == Shape::Kind::mesh ||
         std::any_of(shape.operands.begin(), shape.operands.end(), contains_mesh);
}

}  // namespace pliant
