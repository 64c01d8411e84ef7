#pragma once

#include <cmath>

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Whether a shape is a half-space whose plane lies across `axis`.
inline bool is_plane_across(const Shape& shape, int axis) {
  constexpr double aligned = 1 - 1e-12;
  return shape.kind == Shape::Kind::half_space && std::abs(shape.normal[axis]) > aligned;
}

/// The same for any axis.
inline bool is_plane_along_lattice(const Shape& shape) {
  return is_plane_across(shape, 0) || is_plane_across(shape, 1) || is_plane_across(shape, 2);
}

}  // namespace pliant
