#pragma once

#include <cmath>

#include "engine/geometry/shape.hpp"

namespace pliant {

/// Climbs from a point in steps along the axes and returns the value reached. The first steps have
/// the length `step` [m], later ones are shorter, down to a thousandth of it. Stops when the value
/// is `enough`, since functions may be unbounded.
template <class F>
double climb(const F& value_at, Vector from, int dimension, double step, double enough) {
  constexpr double precise = 1e-6;
  double value = value_at(from);
  for (double along = step; along > precise * step; along /= 2) {
    for (bool rises = true; rises && value < enough;) {
      rises = false;
      for (int k = 0; k < 2 * dimension; ++k) {
        Vector x = from;
        x[k / 2] += k % 2 == 0 ? along : -along;
        const double there = value_at(x);
        if (!(there > value + 1e-9 * std::abs(value))) continue;
        value = there;
        from = x;
        rises = true;
      }
    }
  }
  return value;
}

}  // namespace pliant
