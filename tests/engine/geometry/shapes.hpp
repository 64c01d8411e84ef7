#pragma once

#include <limits>

#include "engine/geometry/shape.hpp"

namespace pliant::tests {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline Shape box(const Vector& lower, const Vector& upper) {
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.lower = lower;
  shape.upper = upper;
  return shape;
}

inline Shape ball(const Vector& centre, double radius) {
  Shape shape;
  shape.kind = Shape::Kind::ball;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

inline Shape capsule(const Vector& from, const Vector& to, double radius) {
  Shape shape;
  shape.kind = Shape::Kind::capsule;
  shape.from = from;
  shape.to = to;
  shape.radius = radius;
  return shape;
}

inline Shape cylinder(const Vector& centre, double radius, const Vector& axis) {
  Shape shape = ball(centre, radius);
  shape.kind = Shape::Kind::cylinder;
  shape.axis = axis;
  return shape;
}

inline Shape half_space(const Vector& point, const Vector& normal) {
  Shape shape;
  shape.kind = Shape::Kind::half_space;
  shape.point = point;
  shape.normal = normal;
  return shape;
}

inline Shape combine(Shape::Kind kind, std::vector<Shape> operands) {
  Shape shape;
  shape.kind = kind;
  shape.operands = std::move(operands);
  return shape;
}

}  // namespace pliant::tests
