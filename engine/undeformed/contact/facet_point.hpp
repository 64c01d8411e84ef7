#pragma once

#include <array>

#include "engine/lattice/point_algebra.hpp"

/// Points of a facet, a segment (2D) or a triangle (3D) with corners at `c`.
namespace pliant::undeformed {

/// Weights of the corners at the point of the facet nearest to `x`.
std::array<double, 2> nearest_weights(const std::array<Point<2>, 2>& c, const Point<2>& x);
std::array<double, 3> nearest_weights(const std::array<Point<3>, 3>& c, const Point<3>& x);

/// Vector to `x` from the point of the facet with these weights of the corners [m].
template <int D>
Point<D> way_from(const std::array<Point<D>, D>& c, const std::array<double, D>& weight,
                  const Point<D>& x) {
  Point<D> way = x;
  for (int v = 0; v < D; ++v) {
    for (int a = 0; a < D; ++a) way[a] -= weight[v] * c[v][a];
  }
  return way;
}

}  // namespace pliant::undeformed
