#pragma once

#include <Eigen/Core>
#include <cmath>

#include "engine/boundaries/walls.hpp"

// A ghost represents a part of its wall. How much of it is in front of the other walls that hold
// bodies:
//
//     |            |
//     |   body     |  another wall
//     |            |
//     g---g---g---g+--g    feet on the wall, h apart
//
// The last ghost before the other wall represents the rest of the wall, less or more than h/2:
// slots beyond the corner belong to the nearer wall.
namespace pliant::remeshed {

/// F of (RP.65), the deformation along a wall since the remeshing.
template <int D>
using WallStretch = Eigen::Matrix<double, D, D>;

/// (RP.65): the share of a ghost with this foot point on a wall with this normal; `apart` [m] is
/// the distance of feet. `stretch()` gives F; it is called only when needed.
template <int D, class Stretch>
double share_in_front_of_walls(const Boundaries<D>& boundaries, int wall, const Point<D>& foot,
                               const Point<D>& normal, double apart, Stretch&& stretch) {
  using Direction = Eigen::Matrix<double, D, 1>;
  constexpr double parallel = 0.3;  // slope of a distance along the wall; smaller: no corner
  constexpr double farthest = 2;    // no stretch brings a wall beyond it closer than 1
  double share = 1;
  for (int w = 0; w < static_cast<int>(boundaries.walls.size()); ++w) {
    const Wall<D>& other = boundaries.walls[w];
    if (w == wall || !other.is_attached()) continue;
    const double distance = other.distance(foot);
    if (distance < 0) return 0;
    if (distance > farthest * apart) continue;
    const Point<D> towards = other.normal(foot);
    const Eigen::Map<const Direction> n(normal.data()), m(towards.data());
    Direction slope = stretch().transpose() * m;
    slope -= slope.dot(n) * n;
    const double before = distance / (apart * slope.norm());
    if (slope.norm() > parallel && before < 1) share *= 0.5 + before;
  }
  return share;
}

template <int D>
double share_in_front_of_walls(const Boundaries<D>& boundaries, int wall, const Point<D>& foot,
                               const Point<D>& normal, double apart) {
  return share_in_front_of_walls<D>(boundaries, wall, foot, normal, apart,
                                    [] { return WallStretch<D>::Identity().eval(); });
}

}  // namespace pliant::remeshed
