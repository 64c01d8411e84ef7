#pragma once

#include <cmath>

#include "engine/geometry/shape.hpp"

namespace pliant {

/// The value of a function that steps along the axes lead to from a point, uphill: the first of
/// length `step` [m], then ever shorter ones, down to a thousandth of it. It ends where the value
/// is `enough`: functions may rise without end.
template <class F>
double climb(const F& value_at, Vector from, int dimension, double step, double enough) {
  constexpr double precise = 1e-3;
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
