#pragma once

#include <span>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/undeformed/contact_surface.hpp"

namespace pliant::undeformed {

/// The present surface of a body, and how far it has moved since a search.
template <class T, int D>
class MovingSurface {
 public:
  MovingSurface(Body<T, D>& body, ContactSurface<D> surface);

  Body<T, D>& body() const { return *body_; }
  const ContactSurface<D>& surface() const { return surface_; }
  const HeldDirections<D>& held() const { return held_; }
  /// Size of its facets [m].
  double spacing() const { return spacing_; }

  /// Where a corner is [m].
  Point<D> place(std::int32_t corner) const;
  std::array<Point<D>, D> places(std::int32_t facet) const;
  /// Of a place over the plane of a facet [m].
  double height(std::int32_t facet, const Point<D>& x) const;
  /// Out of the body at a corner: the mean over the facets around it, by area; a unit vector.
  Point<D> normal(std::int32_t corner) const;

  /// Whether a facet around a corner opposes a surface with this normal; always, for a corner of no
  /// facet.
  bool opposes(std::int32_t corner, const Point<D>& normal) const;

  /// Keeps where the surface is.
  void mark();
  /// Where the corners were then [m].
  const std::vector<Point<D>>& marked_places() const { return marked_place_; }
  /// How it has moved since then.
  struct Motion {
    double most;     ///< never less than the distance of any corner, seen from a frame [m]
    Point<D> drift;  ///< mean displacement [m]
  };
  /// Seen from a frame that has moved by `frame` [m].
  Motion motion(const Point<D>& frame) const;

 private:
  Body<T, D>* body_;
  ContactSurface<D> surface_;
  HeldDirections<D> held_;
  double spacing_;
  std::vector<std::int32_t> first_around_, around_;  ///< facets around each corner
  std::vector<std::int32_t> carriers_;               ///< slots that carry corners, ascending
  double lever_ = 0;                                 ///< most that shares of a corner add up to
  std::vector<Point<D>> marked_;                     ///< [carrier] displacement [m]
  std::vector<Point<D>> marked_place_;               ///< [corner] [m]
};

extern template class MovingSurface<double, 2>;
extern template class MovingSurface<double, 3>;
extern template class MovingSurface<float, 2>;
extern template class MovingSurface<float, 3>;

}  // namespace pliant::undeformed
