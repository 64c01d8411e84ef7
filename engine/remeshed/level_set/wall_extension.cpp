#include "engine/remeshed/level_set/wall_extension.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/corner_weights.hpp"

namespace pliant::remeshed {

namespace {

constexpr double meeting = 3;  // [h] surfaces farther from a wall do not meet it

// Whether a surface that meets a wall leans over it, but does not lie on it. `lean` is the sine of
// the angle between the surface and the normal of the wall.
bool overhangs(double lean) { return lean > 0.05 && lean < 0.95; }

// phi [h] at the rim of a body that overhangs a no-slip wall. The stress is singular there, and
// spread over a spacing it holds less than it should: the wall holds more of the body instead.
double phi_at_rim(double lean) { return -std::min(lean, 0.35) * std::sqrt(1 - lean * lean); }

}  // namespace

template <class T, int D>
void WallExtension<T, D>::extend(const Block<D>& block, const Boundaries<D>& boundaries,
                                 T* extended) const {
  const double h = lattice_.spacing;
  Point<D> centre;
  double radius = 0;
  for (int a = 0; a < D; ++a) {
    centre[a] = (lattice_.node(a, block.lower[a]) + lattice_.node(a, block.upper[a])) / 2;
    radius += std::pow((block.upper[a] - block.lower[a]) * h / 2, 2);
  }
  radius = std::sqrt(radius);
  const bool meets_walls = boundaries.nearest_wall(centre).second < radius;
  const bool may_be_in_contact = boundaries.nearest_contact(centre).second < radius + far_;
  layout_.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
    extended[p] = valid_[p] != 0 ? phi_[p] : T(far_);
    if (!meets_walls && !may_be_in_contact) return;
    const Point<D> x = lattice_.node(cell);
    extended[p] = std::max(extended[p], static_cast<T>(-boundaries.nearest_contact(x).second));
    if (!meets_walls) return;
    if (boundaries.nearest_wall(x).second < 0) {
      extended[p] = static_cast<T>(continued(x, boundaries, 0));
    }
  });
}

// phi where it is known, and behind walls its continuation. Frictionless walls are planes of
// symmetry, (RP.106). Next to one, phi at nodes behind it must not act on itself: there it follows
// the parabola through two points in front. Deeper mirror images would be in blocks that are not
// neighbours.
template <class T, int D>
double WallExtension<T, D>::continued(const Point<D>& x, const Boundaries<D>& boundaries,
                                      int images) const {
  const double h = lattice_.spacing, deepest = 4.5 * h;
  const auto [number, distance] = boundaries.nearest_wall(x);
  if (distance >= 0) {
    double value = 0;
    return interpolate(x, value) ? value : far_;
  }
  const Wall<D>& wall = boundaries.walls[number];
  const double depth = -distance;
  if (!wall.slips() || depth > deepest || images == D) return along_line(x, wall, depth);
  const auto above = [&, normal = wall.normal(x)](double height) {
    Point<D> place = x;
    for (int a = 0; a < D; ++a) place[a] += (depth + height) * normal[a];
    return continued(place, boundaries, images + 1);
  };
  if (depth >= 1.5 * h) return above(depth);
  const double first = above(1.5 * h), second = above(2.5 * h);
  if (std::abs(first) > meeting * h || second >= far_) return first;
  return first + (second - first) * (depth * depth / (h * h) - 2.25) / 4;
}

// phi at `depth` behind a wall, (RP.100): the line through two points 1.5 h and 2.5 h in front of
// it, with the curvature of the initial surface. Only a surface that meets the wall continues
// behind it; far from one, phi keeps its value. A surface that faced the wall from the start ends
// where it touches it, and there the body continues behind the wall. Slopes above 1 are kinks of
// phi. A no-slip wall holds at least what it held at the start; one that the body overhangs holds
// what touches it, as if the surface continued along the normal.
template <class T, int D>
double WallExtension<T, D>::along_line(const Point<D>& x, const Wall<D>& wall, double depth) const {
  constexpr double facing = 0.7;
  const double h = lattice_.spacing;
  const Point<D> normal = wall.normal(x);
  Point<D> nearer = x, farther = x;
  for (int a = 0; a < D; ++a) {
    nearer[a] += (depth + 1.5 * h) * normal[a];
    farther[a] += (depth + 2.5 * h) * normal[a];
  }
  double first = 0, second = 0;
  if (!interpolate(nearer, first)) return far_;
  if (!interpolate(farther, second) || std::abs(first) > meeting * h) return first;
  const auto initial = [&](const Point<D>& place) {
    return signed_distance(initial_surface_, wall.at_rest(place), D);
  };
  const double initial_first = initial(nearer);
  const double initial_slope = (initial_first - initial(farther)) / h;
  const bool faced = initial_slope > facing;
  const double rise = (first - second) / h, steepest = faced ? facing : 1;
  const double slope = std::clamp(rise, -steepest, steepest);
  const double on_wall = first + slope * 1.5 * h;
  if (faced && rise > facing && on_wall < 0) return on_wall;
  const bool met = std::abs(initial_first) <= meeting * h;
  if (!wall.slips() && met && overhangs(initial_slope)) {
    return std::min(on_wall + phi_at_rim(initial_slope) * h, initial(x));
  }
  const double line = on_wall + slope * depth;
  if (std::abs(initial_slope) > facing) return line;
  const double start = initial(x);
  const double value =
      met ? line + start - (initial_first + initial_slope * (1.5 * h + depth)) : line;
  return wall.slips() ? value : std::min(value, start);
}

template <class T, int D>
bool WallExtension<T, D>::interpolate(const Point<D>& x, double& value) const {
  value = 0;
  return for_each_corner<D>(lattice_, x, [&](const Cell<D>& cell, double weight) {
    const std::int64_t p = layout_.slot(lattice_.wrapped(cell));
    if (p < 0 || valid_[p] == 0) return false;
    value += weight * phi_[p];
    return true;
  });
}

template class WallExtension<double, 2>;
template class WallExtension<double, 3>;
template class WallExtension<float, 2>;
template class WallExtension<float, 3>;

}  // namespace pliant::remeshed
