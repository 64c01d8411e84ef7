#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Whether the surface of a shape lies at its radius from a point or an axis.
inline bool is_round(const Shape& shape) {
  using enum Shape::Kind;
  return shape.kind == ball || shape.kind == capsule || shape.kind == cylinder;
}

}  // namespace pliant
