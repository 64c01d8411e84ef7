#include "engine/remeshed/contact/wall_cover.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace pliant::remeshed {

namespace {

constexpr int parts = 4;  // of a cell, along each direction of the wall
// Cosine of the angle between surface and wall from which on the surface is no side: it faces the
// wall and comes down on it, and where the body presses it is in contact.
constexpr double facing = 0.7;

template <int D>
Point<D> moved(Point<D> x, const Point<D>& along, double by) {
  for (int a = 0; a < D; ++a) x[a] += by * along[a];
  return x;
}

/// Unit vectors along a plane.
std::array<Point<2>, 1> tangents(const Point<2>& n) { return {{{-n[1], n[0]}}}; }
std::array<Point<3>, 2> tangents(const Point<3>& n) {
  const Eigen::Vector3d normal(n[0], n[1], n[2]);
  const Eigen::Vector3d first = normal.unitOrthogonal(), second = normal.cross(first);
  return {{{first[0], first[1], first[2]}, {second[0], second[1], second[2]}}};
}

}  // namespace

template <class T, int D>
double WallCover<T, D>::share(const Point<D>& foot, const Point<D>& normal) const {
  const double whole = side_distance(foot, normal) / spacing_;
  if (std::abs(whole) > 1) return whole < 0 ? 1 : 0;
  const std::array<Point<D>, D - 1> along = tangents(normal);
  constexpr int count = D == 2 ? parts : parts * parts;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    Point<D> x = foot;
    for (int a = 0, place = i; a < D - 1; ++a, place /= parts) {
      x = moved<D>(x, along[a], ((place % parts + 0.5) / parts - 0.5) * spacing_);
    }
    sum += std::clamp(0.5 - parts * side_distance(x, normal) / spacing_, 0., 1.);
  }
  return sum / count;
}

// phi of the sides of the body, continued down to the wall from what it is at h and 2 h above.
template <class T, int D>
double WallCover<T, D>::side_distance(const Point<D>& x, const Point<D>& normal) const {
  const double near = level_set_.surface_distance_at(moved<D>(x, normal, spacing_));
  const double far = level_set_.surface_distance_at(moved<D>(x, normal, 2 * spacing_));
  const double rise = near - far;
  return rise > facing * spacing_ ? near : near + std::max(rise, -facing * spacing_);
}

template class WallCover<double, 2>;
template class WallCover<double, 3>;
template class WallCover<float, 2>;
template class WallCover<float, 3>;

}  // namespace pliant::remeshed
