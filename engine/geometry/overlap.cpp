#include "engine/geometry/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/geometry/signed_distance.hpp"

namespace pliant {

double overlap(const Shape& a, const Shape& b, double spacing, int dimension) {
  const Box<3> first = bounding_box(a), second = bounding_box(b);
  Vector lower = {};
  std::array<std::int64_t, 3> count = {1, 1, 1};
  for (int i = 0; i < dimension; ++i) {
    const double low = std::max(first.lower[i], second.lower[i]) - spacing;
    const double high = std::min(first.upper[i], second.upper[i]) + spacing;
    if (low > high) return -(low - high);
    // Shapes without end are the same everywhere along it.
    if (std::isinf(high - low)) continue;
    lower[i] = low;
    count[i] = static_cast<std::int64_t>((high - low) / spacing) + 1;
  }
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::int64_t k = 0; k < count[0] * count[1] * count[2]; ++k) {
    const std::array<std::int64_t, 3> at = {k % count[0], k / count[0] % count[1],
                                            k / count[0] / count[1]};
    Vector x = lower;
    for (int i = 0; i < dimension; ++i) x[i] += spacing * static_cast<double>(at[i]);
    const double inside_a = -signed_distance(a, x, dimension);
    if (inside_a <= deepest) continue;
    deepest = std::max(deepest, std::min(inside_a, -signed_distance(b, x, dimension)));
  }
  return deepest;
}

}  // namespace pliant
