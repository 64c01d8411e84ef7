#include "engine/remeshed/contact/wall_cover.hpp"

#include <algorithm>
#include <cmath>

namespace pliant::remeshed {

namespace {

// [h], as in WallExtension: closer to the wall, phi of a side is that of the bottom.
constexpr double nearer = 1.5, farther = 2.5;

}  // namespace

template <class T, int D>
double WallCover<T, D>::share(const Point<D>& x, const Point<D>& normal) const {
  return std::clamp(0.5 - side(x, normal), 0., 1.);
}

// phi of the sides of the body, extrapolated to the wall.
template <class T, int D>
double WallCover<T, D>::side(const Point<D>& x, const Point<D>& normal) const {
  const double near = phi_above(x, normal, nearer);
  const double rise = near - phi_above(x, normal, farther);
  return rise > facing ? near : near + nearer * std::max(rise, -facing);
}

template <class T, int D>
Point<D> WallCover<T, D>::outward(const Point<D>& x, const Point<D>& normal) const {
  Point<D> gradient;
  double across = 0, square = 0;
  for (int a = 0; a < D; ++a) {
    Point<D> before = x, after = x;
    before[a] -= spacing_ / 2;
    after[a] += spacing_ / 2;
    gradient[a] = phi_above(after, normal, nearer) - phi_above(before, normal, nearer);
    across += gradient[a] * normal[a];
  }
  for (int a = 0; a < D; ++a) {
    gradient[a] -= across * normal[a];
    square += gradient[a] * gradient[a];
  }
  for (double& component : gradient) component = square > 0 ? component / std::sqrt(square) : 0;
  return gradient;
}

template <class T, int D>
double WallCover<T, D>::slope(const Point<D>& x, const Point<D>& normal) const {
  const double rise = phi_above(x, normal, farther) - phi_above(x, normal, nearer);
  return std::clamp(rise, -facing, facing);
}

// phi/h at the height `height` h above the wall.
template <class T, int D>
double WallCover<T, D>::phi_above(Point<D> x, const Point<D>& normal, double height) const {
  for (int a = 0; a < D; ++a) x[a] += height * spacing_ * normal[a];
  return level_set_.phi_at(x) / spacing_;
}

template class WallCover<double, 2>;
template class WallCover<double, 3>;
template class WallCover<float, 2>;
template class WallCover<float, 3>;

}  // namespace pliant::remeshed
