#pragma once

#include <cmath>

#include "engine/lattice/point_algebra.hpp"

namespace pliant::undeformed {

/// What friction has given to a point along a surface with the unit normal n, `given`, and what it
/// gives in one more sweep: enough to take back `slip`, as far as Coulomb's law allows with the
/// coefficient of friction for what was given along n, `pressed`.
template <int D>
Point<D> held_back(Point<D> given, const Point<D>& slip, const Point<D>& n, double compliance,
                   double coefficient, double pressed) {
  const double across = dot<D>(slip, n);
  for (int a = 0; a < D; ++a) given[a] -= (slip[a] - across * n[a]) / compliance;
  const double size = norm<D>(given);
  const double most = pressed > 0 ? coefficient * pressed : 0;
  if (size > most) {
    for (double& component : given) component *= most / size;
  }
  return given;
}

}  // namespace pliant::undeformed
