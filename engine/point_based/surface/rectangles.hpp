#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/body.hpp"

// A face of a lattice in 3D consists of rectangles, of two facets each. The diagonals are parallel:
//
//     o---o---o     By the facets alone, the corners of the face would bear a third or a sixth of
//     | \ | \ |     the load on a rectangle. A uniform stress exerts a quarter on them.
//     o---o---o
namespace pliant::point_based {

/// Finds the facets that fill a rectangle together.
template <int D>
void pair_halves(BodySurface<D>& surface) {
  if (D == 2) return;
  constexpr double rounding = 1e-9;
  surface.other_half.assign(surface.facet.size(), -1);
  std::map<std::pair<std::int32_t, std::int32_t>, std::pair<std::int32_t, Point<D>>> half_at;
  for (std::size_t f = 0; f < surface.facet.size(); ++f) {
    const auto& facet = surface.facet[f];
    for (int v = 0; v < D; ++v) {
      const std::int32_t p = facet[(v + 1) % D], q = facet[(v + 2) % D];
      const Point<D> apex = surface.start[facet[v]];
      const Point<D> a = difference<D>(surface.start[p], apex),
                     b = difference<D>(surface.start[q], apex);
      const double square = dot<D>(a, a) + dot<D>(b, b);
      if (std::abs(dot<D>(a, b)) > rounding * square) continue;
      Point<D> opposite = apex;
      for (int i = 0; i < D; ++i) opposite[i] += a[i] + b[i];
      const auto number = static_cast<std::int32_t>(f);
      const auto [at, is_new] = half_at.insert({std::minmax(p, q), {number, opposite}});
      if (is_new) continue;
      const Point<D> apart = difference<D>(at->second.second, apex);
      if (dot<D>(apart, apart) > rounding * square) continue;
      surface.other_half[f] = at->second.first;
      surface.other_half[at->second.first] = number;
    }
  }
}

/// The corner of a half of a rectangle that the other half lacks, or -1 for other facets.
template <int D>
int apex_of_half(const BodySurface<D>& surface, std::size_t facet) {
  if (surface.other_half.empty() || surface.other_half[facet] < 0) return -1;
  const auto& other = surface.facet[surface.other_half[facet]];
  for (int v = 0; v < D; ++v) {
    if (std::ranges::find(other, surface.facet[facet][v]) == other.end()) return v;
  }
  return -1;
}

/// [corner] shares in a uniform load on a facet with this apex, (PB.68).
template <int D>
std::array<double, D> shares_of_corners(int apex) {
  std::array<double, D> shares;
  shares.fill(apex < 0 ? 1. / D : 0.25);
  if (apex >= 0) shares[apex] = 0.5;
  return shares;
}

/// The middle of the share of corner v in a half of a rectangle: that of its bilinear function.
template <int D>
Point<D> middle_in_half(const std::array<Point<D>, D>& corner, int apex, int v) {
  Point<D> middle = {};
  for (int k = 0; k < D; ++k) {
    const double weight = v == apex ? 1 : k == apex ? 0 : k == v ? 2 : 1;
    for (int a = 0; a < D; ++a) middle[a] += weight / 3 * corner[k][a];
  }
  return middle;
}

}  // namespace pliant::point_based
