#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Signed distances to a shape at successive points that are close, such as lattice nodes.
///
/// Distances change by no more than the way between two points. So the sign near a point deep
/// inside or far outside is known, and only points near the surface need a search.
class DistanceWalk {
 public:
  /// Values whose size is `limit` [m] or more need not be exact.
  DistanceWalk(const Shape& shape, int dimension, double limit)
      : shape_(shape), dimension_(dimension), limit_(limit) {}

  /// The signed distance at `x` if its size is below the limit; otherwise some value with the same
  /// sign and a size of at least the limit.
  double operator()(const Vector& x);

 private:
  const Shape& shape_;
  int dimension_;
  double limit_;
  Vector at_ = {};
  double there_ = 0;  ///< the distance at `at_`
};

}  // namespace pliant
