#pragma once

#include <cmath>

#include "engine/lattice/lattice.hpp"

namespace pliant {

template <int D>
double dot(const Point<D>& a, const Point<D>& b) {
  double sum = 0;
  for (int i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

template <int D>
double norm(const Point<D>& a) {
  return std::sqrt(dot<D>(a, a));
}

/// a - b
template <int D>
Point<D> difference(const Point<D>& a, const Point<D>& b) {
  Point<D> c;
  for (int i = 0; i < D; ++i) c[i] = a[i] - b[i];
  return c;
}

/// A cell as a point [cells].
template <int D>
Point<D> as_point(const Cell<D>& cell) {
  Point<D> x;
  for (int a = 0; a < D; ++a) x[a] = cell[a];
  return x;
}

}  // namespace pliant
