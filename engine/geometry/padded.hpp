#pragma once

#include <algorithm>

#include "engine/geometry/shape.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant {

/// A point with three components, as in case files and shapes: z = 0 in 2D.
template <int D>
Vector padded(const Point<D>& x) {
  Vector v = {};
  std::copy(x.begin(), x.end(), v.begin());
  return v;
}

/// The reverse.
template <int D>
Point<D> unpadded(const Vector& v) {
  Point<D> x;
  std::copy_n(v.begin(), D, x.begin());
  return x;
}

}  // namespace pliant
