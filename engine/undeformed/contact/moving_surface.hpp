#pragma once

#include <span>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/undeformed/contact/surface_patches.hpp"

namespace pliant::undeformed {

/// Velocity and shift of a carrier, or of a point with several carriers, in the contact of a step.
template <int D>
struct ContactMotion {
  Point<D> velocity;  ///< [m/s]
  Point<D> shift;     ///< [m]
};

/// The surface of a body at the end of a step, and its motion since a search.
///
/// Places and normals are computed once a step, and only for watched corners and facets: a corner
/// may have dozens of carriers, and many corners look at one facet. Shares of corners refer to
/// carriers by number.
template <class T, int D>
class MovingSurface {
 public:
  /// A step writes the displacements of the body to its member `moved`.
  MovingSurface(Body<T, D>& body, Displacements<T, D> moved, ContactSurface<D> surface);

  const Body<T, D>& body() const { return *body_; }
  std::int32_t corners() const { return surface_.corners(); }
  std::size_t facets() const { return surface_.facet.size(); }
  const std::array<std::int32_t, D>& facet(std::int32_t facet) const {
    return surface_.facet[facet];
  }
  /// Undeformed places of the corners [m].
  const std::vector<Point<D>>& start() const { return surface_.start; }
  /// Carriers of a corner: numbers of carriers instead of slots, ascending.
  std::span<const Share> shares(std::int32_t corner) const { return surface_.shares(corner); }
  /// Appends the shares of the point of a facet at which the corners have these weights: each
  /// carrier once, ascending.
  void append_shares(std::int32_t facet, const std::array<double, D>& weight,
                     std::vector<Share>& shares) const {
    surface_.append_shares(facet, weight, shares);
  }
  const Carrier<D>& carrier(std::int32_t number) const { return carriers_[number]; }
  bool is_held() const { return !held_.empty(); }
  /// Typical size of facets [m].
  double spacing() const { return spacing_; }

  /// Reads the motion of the carriers, total and since the mark.
  void read_motion();
  /// Marks the present places of the carriers.
  void mark();
  /// [carrier] displacement at the mark [m].
  std::vector<Point<D>>& marked() { return marked_; }
  /// Bounds on the motion since the mark.
  const SurfacePatches<D>& patches() const { return patches_; }
  /// Computes the places of the corners of a patch and of its facets at the mark.
  void find_marked_places(std::size_t patch);
  /// Computes the normal of a facet from the places of its corners.
  void find_normal(std::int32_t facet);

  /// Stops watching all facets and corners.
  void watch_none();
  /// Watches a corner and the facets around it, with their corners.
  void watch(std::int32_t corner);
  std::size_t watched_corners() const { return watched_corners_.size(); }
  std::size_t watched_facets() const { return watched_facets_.size(); }
  std::size_t watched_carriers() const { return watched_carriers_.size(); }
  /// Computes the places of the watched corners `first` to `end` - 1.
  void find_places(std::size_t first, std::size_t end);
  /// Computes the normals of watched facets in the same way, from the places of their corners.
  void find_normals(std::size_t first, std::size_t end);

  /// Place of a corner [m]. This and what follows is only for watched corners and facets.
  const Point<D>& place(std::int32_t corner) const { return place_[corner]; }
  std::array<Point<D>, D> places(std::int32_t facet) const;
  /// Unit normal of a facet, out of the body.
  const Point<D>& facet_normal(std::int32_t facet) const { return normal_[facet]; }
  /// Height of a place above the plane of a facet [m].
  double height(std::int32_t facet, const Point<D>& x) const;
  /// Direction out of the body at the point of a facet at which the corners have these weights. On
  /// an edge or a corner it is the mean over the facets around it, weighted by angle. A place is
  /// inside a closed surface if the way to it from its nearest point runs against this direction.
  Point<D> outwards(std::int32_t facet, const std::array<double, D>& weight) const;
  /// Whether a facet around a corner faces a surface with this normal; true for a corner without
  /// facets.
  bool opposes(std::int32_t corner, const Point<D>& normal) const;

  /// Reads the velocities of the carriers of watched corners in the same way.
  void read_velocities(std::size_t first, std::size_t end);
  /// Velocity of a point, and its shift since velocities were read, from those of its carriers.
  ContactMotion<D> motion(std::span<const Share> shares) const {
    ContactMotion<D> sum = {};
    for (const Share& share : shares) {
      const ContactMotion<D>& carrier = motion_[share.slot];
      for (int a = 0; a < D; ++a) sum.velocity[a] += share.weight * carrier.velocity[a];
      for (int a = 0; a < D; ++a) sum.shift[a] += share.weight * carrier.shift[a];
    }
    return sum;
  }
  /// Adds to the velocity [m/s] and the shift [m] of a carrier.
  void change(std::int32_t number, const Point<D>& velocity, const Point<D>& shift) {
    ContactMotion<D>& carrier = motion_[number];
    for (int a = 0; a < D; ++a) carrier.velocity[a] += velocity[a];
    for (int a = 0; a < D; ++a) carrier.shift[a] += shift[a];
  }
  /// Writes velocities and shifts of the carriers of watched corners into the body; `rate` as
  /// BodyCarriers has it.
  void write_motion(double rate);

 private:
  void find_place(std::int32_t corner, const std::vector<Point<D>>& displacement);
  void watch_corner(std::int32_t corner);

  Body<T, D>* body_;
  Displacements<T, D> moved_;
  ContactSurface<D> surface_;
  HeldDirections<D> held_;
  double spacing_;
  std::vector<Carrier<D>> carriers_;
  Groups around_;  ///< [corner] facets around it
  SurfacePatches<D> patches_;
  std::vector<Point<D>> displacement_, marked_;  ///< [carrier] [m]
  std::vector<ContactMotion<D>> motion_;         ///< [carrier]
  std::vector<Point<D>> place_;                  ///< [corner] [m]
  std::vector<Point<D>> normal_;                 ///< [facet]
  std::vector<std::int32_t> watched_corners_, watched_facets_, watched_carriers_;
  std::vector<bool> is_corner_watched_, is_facet_watched_, is_carrier_watched_;
  std::vector<bool> is_ring_watched_;  ///< [corner] whether all facets around it are watched
};

extern template class MovingSurface<double, 2>;
extern template class MovingSurface<double, 3>;
extern template class MovingSurface<float, 2>;
extern template class MovingSurface<float, 3>;

}  // namespace pliant::undeformed
