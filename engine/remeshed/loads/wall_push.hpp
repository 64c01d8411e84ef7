#pragma once

#include "engine/boundaries/wrench.hpp"

namespace pliant::remeshed {

/// What a wall gives to a block, or to all, in a step by (RP.65), with its moment, (RP.115).
template <int D>
struct WallPush {
  Wrench<D> given;       ///< [N s], [N m s]
  double weight = 0;     ///< area times time [m^(D-1) s]
  Point<D> places = {};  ///< feet of the ghosts, times their weights

  void add(const Point<D>& foot, const Point<D>& impulse, double of_ghost) {
    given.add(foot, impulse);
    weight += of_ghost;
    for (int a = 0; a < D; ++a) places[a] += of_ghost * foot[a];
  }

  void add(const WallPush& other) {
    given.add(other.given, 1);
    weight += other.weight;
    for (int a = 0; a < D; ++a) places[a] += other.places[a];
  }

  /// The same if the impulse is `whole`: what it lacks acts at the mean of the places.
  Wrench<D> completed(const Point<D>& whole) const {
    Wrench<D> wrench = given;
    Point<D> at = places, rest = whole;
    for (int a = 0; a < D; ++a) {
      if (weight > 0) at[a] /= weight;
      rest[a] -= given.force[a];
    }
    wrench.add(at, rest);
    return wrench;
  }
};

}  // namespace pliant::remeshed
