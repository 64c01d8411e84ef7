#pragma once

#include "engine/boundaries/rigid_motion.hpp"

namespace pliant {

/// A force [N] and its moment about the origin [N m], or their impulses.
template <int D>
struct Wrench {
  Point<D> force = {};
  Vector moment = {};  ///< in 2D about z

  /// Adds a force that acts at x.
  void add(const Point<D>& x, const Point<D>& by) {
    const Vector turning = cross(padded<D>(x), padded<D>(by));
    for (int a = 0; a < D; ++a) force[a] += by[a];
    for (int a = 0; a < 3; ++a) moment[a] += turning[a];
  }

  void add(const Wrench& other, double factor) {
    for (int a = 0; a < D; ++a) force[a] += factor * other.force[a];
    for (int a = 0; a < 3; ++a) moment[a] += factor * other.moment[a];
  }

  /// Moment about a point.
  Vector moment_about(const Vector& point) const {
    const Vector of_force = cross(point, padded<D>(force));
    Vector about = moment;
    for (int a = 0; a < 3; ++a) about[a] -= of_force[a];
    return about;
  }
};

}  // namespace pliant
