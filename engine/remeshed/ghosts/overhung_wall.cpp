#include "engine/remeshed/ghosts/overhung_wall.hpp"

#include <limits>

#include "engine/lattice/point_algebra.hpp"
#include "engine/remeshed/ghosts/reentrant_corners.hpp"

namespace pliant::remeshed {

// A hollow that meets the wall at a right angle leans, too, above the wall. With a slope -n.w that
// is linear in the height, the one at the wall follows from phi below the place.
template <class T, int D>
double distance_to_overhung_wall(const Boundaries<D>& boundaries, const LevelSet<T, D>& level_set,
                                 double h, const Point<D>& place, const Point<D>& outward) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double leaning = 0.2, low = 0.75, high = 1.5;  // heights in h
  const auto [nearest, height] = boundaries.nearest_wall(place);
  if (nearest < 0 || !boundaries.walls[nearest].slips() || height > corner_reach * h) {
    return infinity;
  }
  const Point<D> w = boundaries.walls[nearest].normal(place);
  double slope = -dot<D>(w, outward);
  if (height > high * h) {
    const double drop = height - low * h;
    Point<D> below = place;
    for (int a = 0; a < D; ++a) below[a] -= drop * w[a];
    slope = 2 * level_set.phi_at(below) / drop - slope;
  }
  return slope > leaning ? height : infinity;
}

template double distance_to_overhung_wall<double, 2>(const Boundaries<2>&,
                                                     const LevelSet<double, 2>&, double,
                                                     const Point<2>&, const Point<2>&);
template double distance_to_overhung_wall<double, 3>(const Boundaries<3>&,
                                                     const LevelSet<double, 3>&, double,
                                                     const Point<3>&, const Point<3>&);
template double distance_to_overhung_wall<float, 2>(const Boundaries<2>&, const LevelSet<float, 2>&,
                                                    double, const Point<2>&, const Point<2>&);
template double distance_to_overhung_wall<float, 3>(const Boundaries<3>&, const LevelSet<float, 3>&,
                                                    double, const Point<3>&, const Point<3>&);

}  // namespace pliant::remeshed
