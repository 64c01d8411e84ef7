#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::undeformed {

/// Items of many groups, one group after the other.
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

/// A ball that contains the displacements of all points of something [m].
template <int D>
struct MotionBall {
  Point<D> centre = {};
  double radius = 0;
};

/// Never less than the change of the distance between any two points that have moved so [m].
template <int D>
double relative_motion(const MotionBall<D>& a, const MotionBall<D>& b) {
  const Point<D> apart = difference<D>(a.centre, b.centre);
  return std::sqrt(dot<D>(apart, apart)) + a.radius + b.radius;
}

/// A surface in patches of a few facets across, each of which has a bound on how far it has moved.
///
/// Corners are weighted sums of particles, x = sum_i w_i x_i with sum_i w_i = 1, so that
/// displacements u_i in a ball around c give abs(u - c) <= sum_i abs(w_i) max_i abs(u_i - c). As c
/// is that of the patch, not of the body, bodies that turn or whose far ends move apart keep small
/// bounds where they touch, (TL.20).
template <int D>
class SurfacePatches {
 public:
  SurfacePatches() = default;
  /// `surface` has the numbers of carriers in the place of slots; `size` is that of its facets [m].
  SurfacePatches(const ContactSurface<D>& surface, std::size_t carriers, double size);

  std::size_t count() const { return corners_.count(); }
  /// Corners that belong to a patch, each to one; none belongs to several.
  std::span<const std::int32_t> corners(std::size_t patch) const { return corners_[patch]; }
  std::span<const std::int32_t> facets(std::size_t patch) const { return facets_[patch]; }

  /// Takes what carriers have moved by [m].
  void measure(const std::vector<Point<D>>& displacement, const std::vector<Point<D>>& marked);
  /// Of the corners and the facets of a patch.
  const MotionBall<D>& motion(std::size_t patch) const { return motion_[patch]; }
  /// Mean displacement [m].
  const Point<D>& drift() const { return drift_; }
  /// Largest motion of a patch, seen from a frame that has moved by `frame` [m].
  double largest_motion(const Point<D>& frame) const;

 private:
  Groups corners_, facets_, carriers_;     ///< [patch]
  Groups sources_;                         ///< [patch] patches whose carriers carry its corners
  std::vector<double> leverage_;           ///< [patch] most that abs(w) of a corner add up to
  std::vector<MotionBall<D>> carried_by_;  ///< [patch] motion of its carriers
  std::vector<MotionBall<D>> motion_;
  Point<D> drift_ = {};
};

extern template class SurfacePatches<2>;
extern template class SurfacePatches<3>;

}  // namespace pliant::undeformed
