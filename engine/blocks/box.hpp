#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace pliant {

/// A box with sides along the axes. It is empty until it has grown, and may be infinite.
template <int D>
struct Box {
  std::array<double, D> lower = filled(std::numeric_limits<double>::infinity());
  std::array<double, D> upper = filled(-std::numeric_limits<double>::infinity());

  void grow(const Box& other) {
    for (int a = 0; a < D; ++a) {
      lower[a] = std::min(lower[a], other.lower[a]);
      upper[a] = std::max(upper[a], other.upper[a]);
    }
  }
  void grow(const std::array<double, D>& point) { grow(Box{point, point}); }

  static std::array<double, D> filled(double value) {
    std::array<double, D> all;
    all.fill(value);
    return all;
  }
};

/// Square of the smallest distance between points of two boxes; rounding never makes it larger than
/// that.
template <int D>
double squared_gap(const Box<D>& a, const Box<D>& b) {
  double sum = 0;
  for (int i = 0; i < D; ++i) {
    const double gap = std::max({0.0, a.lower[i] - b.upper[i], b.lower[i] - a.upper[i]});
    sum += gap * gap;
  }
  return sum;
}

}  // namespace pliant
