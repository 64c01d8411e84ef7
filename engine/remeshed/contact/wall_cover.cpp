#include "engine/remeshed/contact/wall_cover.hpp"

#include <algorithm>

namespace pliant::remeshed {

namespace {

// [h], as in WallExtension: below the first, phi of a side is that of the bottom.
constexpr double nearer = 1.5, farther = 2.5;

}  // namespace

// phi of the sides of the body, continued down to the wall.
template <class T, int D>
double WallCover<T, D>::share(const Point<D>& x, const Point<D>& normal) const {
  const double near = phi_above(x, normal, nearer);
  const double rise = near - phi_above(x, normal, farther);
  const double side = rise > facing ? near : near + nearer * std::max(rise, -facing);
  return std::clamp(0.5 - side, 0., 1.);
}

template <class T, int D>
double WallCover<T, D>::slope(const Point<D>& x, const Point<D>& normal) const {
  const double rise = phi_above(x, normal, farther) - phi_above(x, normal, nearer);
  return std::clamp(rise, -facing, facing);
}

// phi/h at a height of so many h above the wall.
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
