#pragma once

#include "engine/remeshed/level_set/level_set.hpp"

// How much of a contact wall a body covers.
//
//      |    body    |
//      |  x x x x x |            sides, seen at heights of 1.5 h and 2.5 h
//      |____________|
//     ----g--g--g--g--g----wall
//
// Ghosts along a wall each represent h^(d-1) of it. What is beyond the edge of a body must not
// count, or the wall would push on a larger area than the body has. The level set does not show the
// edge, since it ends at the wall, (RP.54), but the sides above do.
namespace pliant::remeshed {

template <class T, int D>
class WallCover {
 public:
  /// Cosine of the angle between surface and wall above which the surface is no side: it faces the
  /// wall and approaches it, and where the body presses it is in contact.
  static constexpr double facing = 0.7;

  WallCover(const Lattice<D>& lattice, const LevelSet<T, D>& level_set)
      : spacing_(lattice.spacing), level_set_(level_set) {}

  /// (RP.80): the share of h^(d-1) of a wall around its point x that the body covers; `normal` of
  /// the wall points into the body.
  double share(const Point<D>& x, const Point<D>& normal) const;
  /// Distance of x beyond the edge, over h, along `outward`, a unit vector along the wall, or 0 if
  /// the body has no side.
  double side(const Point<D>& x, const Point<D>& normal) const;
  Point<D> outward(const Point<D>& x, const Point<D>& normal) const;
  /// The component along `normal` of the unit normal of the side above x.
  double slope(const Point<D>& x, const Point<D>& normal) const;

 private:
  double phi_above(Point<D> x, const Point<D>& normal, double height) const;

  double spacing_;
  const LevelSet<T, D>& level_set_;
};

extern template class WallCover<double, 2>;
extern template class WallCover<double, 3>;
extern template class WallCover<float, 2>;
extern template class WallCover<float, 3>;

}  // namespace pliant::remeshed
