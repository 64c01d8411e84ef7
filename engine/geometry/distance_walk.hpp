#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Signed distances to a shape at points that follow each other closely, as lattice nodes do.
///
/// A distance changes by no more than the way between two points. From a point that lies deep
/// inside or far outside, the sign at its neighbours is known without asking the shape again, so
/// that only points near the surface cost a search.
class DistanceWalk {
 public:
  /// Values of size `limit` [m] or more need not be exact.
  DistanceWalk(const Shape& shape, int dimension, double limit)
      : shape_(shape), dimension_(dimension), limit_(limit) {}

  /// The signed distance at `x` where it is smaller than the limit; otherwise some value of the
  /// same sign, of the limit's size or more.
  double operator()(const Vector& x);

 private:
  const Shape& shape_;
  int dimension_;
  double limit_;
  Vector at_ = {};
  double there_ = 0;  ///< the distance at `at_`
};

}  // namespace pliant
