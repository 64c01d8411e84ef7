#pragma once

#include <span>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/undeformed/contact_surface.hpp"

namespace pliant::undeformed {

/// The surface of a body at the end of a step, and how far it has moved since a search.
///
/// Places and planes are evaluated once a step, and only those that a search watches: a corner may
/// follow dozens of nodes, and many corners look at one facet.
template <class T, int D>
class MovingSurface {
 public:
  /// A step leaves the displacements of the body in its member `moved`.
  MovingSurface(Body<T, D>& body, Displacements<T, D> moved, ContactSurface<D> surface);

  Body<T, D>& body() const { return *body_; }
  std::array<Buffer<T>, D>& displacement() const { return body_->*moved_; }
  const ContactSurface<D>& surface() const { return surface_; }
  const HeldDirections<D>& held() const { return held_; }
  /// Size of its facets [m].
  double spacing() const { return spacing_; }

  /// Watches no facet and no corner.
  void watch_none();
  /// Watches a corner and the facets around it, with their corners.
  void watch(std::int32_t corner);
  std::size_t watched_corners() const { return watched_corners_.size(); }
  std::size_t watched_facets() const { return watched_facets_.size(); }
  /// Evaluates where the watched corners are, from number `first` to before `end`.
  void find_places(std::size_t first, std::size_t end);
  /// Evaluates the normals of watched facets, alike, from the places of their corners.
  void find_normals(std::size_t first, std::size_t end);

  /// Where a corner is [m]; as all that follows, of what is watched.
  const Point<D>& place(std::int32_t corner) const { return place_[corner]; }
  std::array<Point<D>, D> places(std::int32_t facet) const;
  /// Unit normal of a facet, out of the body.
  const Point<D>& facet_normal(std::int32_t facet) const { return normal_[facet]; }
  /// Of a place over the plane of a facet [m].
  double height(std::int32_t facet, const Point<D>& x) const;
  /// Out of the body at a corner: the mean over the facets around it, by area; a unit vector.
  Point<D> normal(std::int32_t corner) const;

  /// Whether a facet around a corner opposes a surface with this normal; always, for a corner of no
  /// facet.
  bool opposes(std::int32_t corner, const Point<D>& normal) const;

  /// Keeps where the surface is, and evaluates all of it.
  void mark();
  /// Where the corners were when they were last evaluated [m].
  const std::vector<Point<D>>& all_places() const { return place_; }
  /// How it has moved since then.
  struct Motion {
    double most;     ///< never less than the distance of any corner, seen from a frame [m]
    Point<D> drift;  ///< mean displacement [m]
  };
  /// Seen from a frame that has moved by `frame` [m].
  Motion motion(const Point<D>& frame) const;

 private:
  void find_place(std::int32_t corner);
  void find_normal(std::int32_t facet);
  void watch_corner(std::int32_t corner);

  Body<T, D>* body_;
  Displacements<T, D> moved_;
  ContactSurface<D> surface_;
  HeldDirections<D> held_;
  double spacing_;
  std::vector<std::int32_t> first_around_, around_;  ///< facets around each corner
  std::vector<std::int32_t> carriers_;               ///< slots that carry corners, ascending
  double lever_ = 0;                                 ///< most that shares of a corner add up to
  std::vector<Point<D>> marked_;                     ///< [carrier] displacement [m]
  std::vector<Point<D>> place_;                      ///< [corner] [m]
  std::vector<Point<D>> normal_;                     ///< [facet]
  std::vector<std::int32_t> watched_corners_, watched_facets_;
  std::vector<bool> is_corner_watched_, is_facet_watched_;
  std::vector<bool> is_ring_watched_;  ///< [corner] all facets around it
};

extern template class MovingSurface<double, 2>;
extern template class MovingSurface<double, 3>;
extern template class MovingSurface<float, 2>;
extern template class MovingSurface<float, 3>;

}  // namespace pliant::undeformed
