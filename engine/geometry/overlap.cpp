#include "engine/geometry/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/geometry/climb.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

namespace {

constexpr std::size_t climbers = 8;
/// Of points from the spacing. Points on the faces of bodies, which are often multiples of the
/// spacing, would be at the edges of what overlaps, where no axis leads to a deeper point.
constexpr double offset = 0.382;

/// Keeps the deepest points, in descending order of depth.
void keep(std::vector<std::pair<double, Vector>>& deepest,
          const std::pair<double, Vector>& candidate) {
  if (deepest.size() == climbers && candidate.first <= deepest.back().first) return;
  const auto shallower =
      std::ranges::find_if(deepest, [&](const auto& one) { return one.first < candidate.first; });
  deepest.insert(shallower, candidate);
  if (deepest.size() > climbers) deepest.pop_back();
}

}  // namespace

double overlap(const Shape& a, const Shape& b, double spacing, int dimension) {
  const Box<3> first = bounding_box(a), second = bounding_box(b);
  Vector lower = {};
  std::array<std::int64_t, 3> count = {1, 1, 1};
  for (int i = 0; i < dimension; ++i) {
    const double low = std::max(first.lower[i], second.lower[i]) - spacing;
    const double high = std::min(first.upper[i], second.upper[i]) + spacing;
    if (low > high) return -(low - high);
    // Infinite shapes are the same everywhere along their axis.
    if (std::isinf(high - low)) continue;
    lower[i] = low + offset * spacing;
    count[i] = static_cast<std::int64_t>((high - low) / spacing) + 1;
  }
  const auto inside = [&](const Shape& shape, const Vector& x) {
    return -signed_distance(shape, x, dimension);
  };
  std::vector<std::pair<double, Vector>> found;
  for (std::int64_t k = 0; k < count[0] * count[1] * count[2]; ++k) {
    const std::array<std::int64_t, 3> at = {k % count[0], k / count[0] % count[1],
                                            k / count[0] / count[1]};
    Vector x = lower;
    for (int i = 0; i < dimension; ++i) x[i] += spacing * static_cast<double>(at[i]);
    const double inside_a = inside(a, x);
    if (found.size() == climbers && inside_a <= found.back().first) continue;
    keep(found, {std::min(inside_a, inside(b, x)), x});
  }
  const auto depth = [&](const Vector& x) { return std::min(inside(a, x), inside(b, x)); };
  constexpr double endless = std::numeric_limits<double>::infinity();
  double deepest = -endless;
  for (const auto& [there, x] : found) {
    deepest = std::max(deepest, climb(depth, x, dimension, spacing / 2, endless));
  }
  return deepest;
}

}  // namespace pliant
