#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::undeformed {

/// Items of many groups, one group after another.
struct Groups {
  std::vector<std::int32_t> first = {0};  ///< [group + 1]
  std::vector<std::int32_t> item;

  Groups() = default;
  /// Item i belongs to group `group[i]`.
  Groups(std::span<const std::int32_t> group, std::size_t count);

  std::size_t count() const { return first.size() - 1; }
  std::span<const std::int32_t> operator[](std::size_t group) const {
    return {item.data() + first[group], item.data() + first[group + 1]};
  }
};

/// Numbers of the facets at each corner, ascending.
template <int D>
Groups facets_around_corners(const ContactSurface<D>& surface);

/// A ball that contains the displacements of a set of points [m].
template <int D>
struct MotionBall {
  Point<D> centre = {};
  double radius = 0;
};

/// An upper bound on the change of the distance between two points with these motions [m].
template <int D>
double relative_motion(const MotionBall<D>& a, const MotionBall<D>& b) {
  const Point<D> apart = difference<D>(a.centre, b.centre);
  return std::sqrt(dot<D>(apart, apart)) + a.radius + b.radius;
}

/// A surface, divided into patches a few facets wide, each with a bound on its motion.
///
/// Corners are weighted sums of particles, x = sum_i w_i x_i with sum_i w_i = 1. If the
/// displacements u_i are in a ball around c, then abs(u - c) <= sum_i abs(w_i) max_i abs(u_i - c).
/// Since c belongs to a patch, bounds stay small where bodies touch even if the bodies rotate or
/// their far ends move apart, (TL.20).
template <int D>
class SurfacePatches {
 public:
  SurfacePatches() = default;
  /// `surface` has numbers of carriers instead of slots; `size` is the size of its facets [m].
  SurfacePatches(const ContactSurface<D>& surface, std::size_t carriers, double size);

  std::size_t count() const { return corners_.count(); }
  /// Corners of a patch; each corner belongs to one patch.
  std::span<const std::int32_t> corners(std::size_t patch) const { return corners_[patch]; }
  std::span<const std::int32_t> facets(std::size_t patch) const { return facets_[patch]; }

  /// Computes the bounds from the present and the marked displacements of the carriers [m].
  void measure(const std::vector<Point<D>>& displacement, const std::vector<Point<D>>& marked);
  /// The motion of the corners and facets of a patch.
  const MotionBall<D>& motion(std::size_t patch) const { return motion_[patch]; }
  /// Mean displacement [m].
  const Point<D>& drift() const { return drift_; }
  /// Largest motion of a patch relative to a frame that has moved by `frame` [m].
  double largest_motion(const Point<D>& frame) const;

 private:
  Groups corners_, facets_, carriers_;  ///< [patch]
  Groups sources_;                      ///< [patch] patches whose carriers carry its corners
  std::vector<double> leverage_;  ///< [patch] largest sum of abs(w) over the carriers of a corner
  std::vector<MotionBall<D>> carried_by_;  ///< [patch] motion of its carriers
  std::vector<MotionBall<D>> motion_;
  Point<D> drift_ = {};
};

extern template class SurfacePatches<2>;
extern template class SurfacePatches<3>;

}  // namespace pliant::undeformed
