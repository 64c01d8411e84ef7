#pragma once

#include "engine/remeshed/level_set/level_set.hpp"

// How much of a contact wall a body covers.
//
//      |    body    |
//      |  x x x x x |            sides, seen at heights of 1.5 h and 2.5 h
//      |____________|
//     ----g--g--g--g--g----wall
//
// Ghosts stand side by side along a wall, one for each h^(d-1) of it. What lies beyond the edge of
// a body must not count, or a wall would push on more than there is. The level set itself does not
// tell where the edge is: it ends at the wall, (RP.54). Its sides above do.
namespace pliant::remeshed {

template <class T, int D>
class WallCover {
 public:
  /// Cosine of the angle between surface and wall from which on the surface is no side: it faces
  /// the wall and comes down on it, and where the body presses it is in contact.
  static constexpr double facing = 0.7;

  WallCover(const Lattice<D>& lattice, const LevelSet<T, D>& level_set)
      : spacing_(lattice.spacing), level_set_(level_set) {}

  /// (RP.80): the share of the h^(d-1) of a wall about its point x that the body covers; `normal`
  /// of the wall, into the body.
  double share(const Point<D>& x, const Point<D>& normal) const;
  /// How far beyond the edge x lies, over h, along `outward`, a unit vector along the wall, or 0
  /// where the body has no side.
  double side(const Point<D>& x, const Point<D>& normal) const;
  Point<D> outward(const Point<D>& x, const Point<D>& normal) const;
  /// The part along `normal` of the unit normal of the side above x.
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
