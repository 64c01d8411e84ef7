#pragma once

#include "engine/remeshed/level_set/level_set.hpp"

// How much of a contact wall a body covers.
//
//      |    body    |
//      |  x x x x x |            sides, seen at heights of h and 2 h
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
  WallCover(const Lattice<D>& lattice, const LevelSet<T, D>& level_set)
      : spacing_(lattice.spacing), level_set_(level_set) {}

  /// (RP.80): the share of the h^(d-1) of a wall about a foot point that the body covers; `normal`
  /// of the wall, into the body.
  double share(const Point<D>& foot, const Point<D>& normal) const;

 private:
  double side_distance(const Point<D>& x, const Point<D>& normal) const;

  double spacing_;
  const LevelSet<T, D>& level_set_;
};

extern template class WallCover<double, 2>;
extern template class WallCover<double, 3>;
extern template class WallCover<float, 2>;
extern template class WallCover<float, 3>;

}  // namespace pliant::remeshed
