#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::undeformed {

/// The part of a body's surface for which a point of a facet stands, (TL.29).
template <int D>
struct SurfacePlace {
  Point<D> place;   ///< [m]
  double area = 1;  ///< of the surface, over that of the facet
};

/// Follows the unit normal of a facet from its point `x` to the surface of `shape`. A facet that
/// cuts off an edge stands for the faces that meet there. `x` itself where the surface is farther
/// away than the spacing `h` [m].
template <int D>
SurfacePlace<D> surface_place(const Shape& shape, const Point<D>& x, const Point<D>& normal,
                              double h) {
  constexpr double reached = 1e-6, on_surface = 1e-9;  // [h]
  constexpr double least_cosine = 0.5;                 // between the facet and the surface
  constexpr int most_steps = 32;
  const double first = signed_distance(shape, padded<D>(x), D);
  if (std::abs(first) <= on_surface * h) return {x};
  Point<D> place = x;
  double way = 0, left = first;
  for (int i = 0; i < most_steps && std::abs(left) > reached * h; ++i) {
    way -= left;
    if (std::abs(way) > h) return {x};
    for (int a = 0; a < D; ++a) place[a] = x[a] + way * normal[a];
    left = signed_distance(shape, padded<D>(place), D);
  }
  const Vector outward = outward_direction(shape, padded<D>(place), D);
  double cosine = 0;
  for (int a = 0; a < D; ++a) cosine += outward[a] * normal[a];
  return {place, 1 / std::max(cosine, least_cosine)};
}

}  // namespace pliant::undeformed
