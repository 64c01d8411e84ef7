#pragma once

#include "engine/lattice/lattice.hpp"

namespace pliant {

/// a . b
template <int D>
double dot(const Point<D>& a, const Point<D>& b) {
  double sum = 0;
  for (int i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

/// a - b
template <int D>
Point<D> difference(const Point<D>& a, const Point<D>& b) {
  Point<D> c;
  for (int i = 0; i < D; ++i) c[i] = a[i] - b[i];
  return c;
}

}  // namespace pliant
