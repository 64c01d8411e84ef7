#include "engine/geometry/distance_walk.hpp"

#include <cmath>

#include "engine/geometry/signed_distance.hpp"

namespace pliant {

double DistanceWalk::operator()(const Vector& x) {
  double square = 0;
  for (int i = 0; i < dimension_; ++i) square += (x[i] - at_[i]) * (x[i] - at_[i]);
  // Reduced by more than rounding.
  const double least = std::abs(there_) * (1 - 1e-9) - std::sqrt(square);
  if (least > 0 && least >= limit_) return std::copysign(least, there_);
  at_ = x;
  there_ = signed_distance(shape_, x, dimension_);
  return there_;
}

}  // namespace pliant
