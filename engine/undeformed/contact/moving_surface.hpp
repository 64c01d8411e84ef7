#pragma once

#include <span>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/undeformed/contact/surface_patches.hpp"

namespace pliant::undeformed {

/// Velocity and shift of a carrier, or of a point that moves with several, in the contact of a
/// step.
template <int D>
struct Pushed {
  Point<D> velocity;  ///< [m/s]
  Point<D> shift;     ///< [m]
};

/// The surface of a body at the end of a step, and how far it has moved since a search.
///
/// Places and planes are evaluated once a step, and only those that a search watches: a corner may
/// follow dozens of nodes, and many corners look at one facet. What is read of the body lies
/// together for each particle; the shares of corners have the numbers of these carriers.
template <class T, int D>
class MovingSurface {
 public:
  /// A step leaves the displacements of the body in its member `moved`.
  MovingSurface(Body<T, D>& body, Displacements<T, D> moved, ContactSurface<D> surface);

  const Body<T, D>& body() const { return *body_; }
  std::int32_t corners() const { return surface_.corners(); }
  std::size_t facets() const { return surface_.facet.size(); }
  const std::array<std::int32_t, D>& facet(std::int32_t facet) const {
    return surface_.facet[facet];
  }
  /// Where corners are in the undeformed body [m].
  const std::vector<Point<D>>& start() const { return surface_.start; }
  /// What a corner moves with: numbers of carriers in the place of slots, ascending.
  std::span<const Share> shares(std::int32_t corner) const { return surface_.shares(corner); }
  /// Appends the shares of a point of a facet, whose corners have these weights there: each carrier
  /// once, ascending.
  void append_shares(std::int32_t facet, const std::array<double, D>& weight,
                     std::vector<Share>& shares) const {
    surface_.append_shares(facet, weight, shares);
  }
  const Carrier<D>& carrier(std::int32_t number) const { return carriers_[number]; }
  bool is_held() const { return !held_.empty(); }
  /// Size of its facets [m].
  double spacing() const { return spacing_; }

  /// Reads how far the carriers have moved, and how far that is from where they were marked.
  void read_motion();
  /// Marks the carriers where they are.
  void mark();
  /// [carrier] displacement at the mark [m].
  std::vector<Point<D>>& marked() { return marked_; }
  /// Bounds on the motion since the mark.
  const SurfacePatches<D>& patches() const { return patches_; }
  /// Evaluates where the corners of a patch and of its facets were at the mark.
  void find_marked_places(std::size_t patch);
  /// Evaluates the normal of a facet from the places of its corners.
  void find_normal(std::int32_t facet);

  /// Watches no facet and no corner.
  void watch_none();
  /// Watches a corner and the facets around it, with their corners.
  void watch(std::int32_t corner);
  std::size_t watched_corners() const { return watched_corners_.size(); }
  std::size_t watched_facets() const { return watched_facets_.size(); }
  std::size_t watched_carriers() const { return watched_carriers_.size(); }
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
  /// Direction out of the body at a point of a facet, whose corners have these weights there: on an
  /// edge or a corner the mean of the facets around it, by angle. With it, a place whose nearest
  /// point of a closed surface that is lies inside where the way from there runs against it.
  Point<D> outwards(std::int32_t facet, const std::array<double, D>& weight) const;
  /// Whether a facet around a corner opposes a surface with this normal; always, for a corner of no
  /// facet.
  bool opposes(std::int32_t corner, const Point<D>& normal) const;

  /// Reads the velocities of the carriers of watched corners, alike.
  void read_velocities(std::size_t first, std::size_t end);
  /// Velocity and shift, since they were read, of a point from those of its carriers.
  Pushed<D> pushed(std::span<const Share> shares) const;
  /// Adds to the velocity [m/s] and the shift [m] of a carrier.
  void change(std::int32_t number, const Point<D>& velocity, const Point<D>& shift);
  /// Writes velocities and shifts of the carriers of watched corners into the body.
  void write_pushed();

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
  std::vector<Pushed<D>> pushed_;                ///< [carrier]
  std::vector<Point<D>> place_;                  ///< [corner] [m]
  std::vector<Point<D>> normal_;                 ///< [facet]
  std::vector<std::int32_t> watched_corners_, watched_facets_, watched_carriers_;
  std::vector<bool> is_corner_watched_, is_facet_watched_, is_carrier_watched_;
  std::vector<bool> is_ring_watched_;  ///< [corner] all facets around it
};

extern template class MovingSurface<double, 2>;
extern template class MovingSurface<double, 3>;
extern template class MovingSurface<float, 2>;
extern template class MovingSurface<float, 3>;

}  // namespace pliant::undeformed
