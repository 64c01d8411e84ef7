#pragma once

#include <algorithm>

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Whether the surface of a shape lies at its radius from a point or an axis.
inline bool is_round(const Shape& shape) {
  using enum Shape::Kind;
  return shape.kind == ball || shape.kind == capsule || shape.kind == cylinder;
}

/// Whether a shape, or a part of it, is round.
inline bool has_round_part(const Shape& shape) {
  return is_round(shape) || std::ranges::any_of(shape.operands, has_round_part);
}

}  // namespace pliant
