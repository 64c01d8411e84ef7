#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/lattice/point_algebra.hpp"
#include "engine/undeformed/contact/carried_points.hpp"

namespace pliant::undeformed {

/// The surface of a body for contact with other bodies: segments (2D) or triangles (3D) between
/// corners that move with the particles.
template <int D>
struct ContactSurface {
  std::vector<Point<D>> start;                  ///< [corner] in the undeformed body [m]
  std::vector<std::int32_t> first_share = {0};  ///< [corner + 1]
  std::vector<Share> share;                     ///< carriers of the corners
  /// [corner] bound on the difference between its displacement and that of its first carrier [m].
  std::vector<double> reach;
  std::vector<std::array<std::int32_t, D>> facet;  ///< corners, ordered as seen from outside
  bool is_whole = true;                            ///< whether no cut divides its facets
  /// Corners from this one on are particles inside the body.
  std::int32_t first_inner = std::numeric_limits<std::int32_t>::max();

  std::int32_t corners() const { return static_cast<std::int32_t>(start.size()); }
  std::span<const Share> shares(std::int32_t corner) const {
    return {share.data() + first_share[corner], share.data() + first_share[corner + 1]};
  }
  /// Adds a corner with its carriers.
  void add(const Point<D>& at, std::span<const Share> shares,
           double farthest = std::numeric_limits<double>::infinity()) {
    start.push_back(at);
    reach.push_back(farthest);
    share.insert(share.end(), shares.begin(), shares.end());
    first_share.push_back(static_cast<std::int32_t>(share.size()));
  }
  /// Appends the shares of the point of facet `number` at which the corners have these weights:
  /// each slot once, in ascending order if those of each corner are.
  void append_shares(std::int32_t number, const std::array<double, D>& weight,
                     std::vector<Share>& of_point) const;
};

template <int D>
void ContactSurface<D>::append_shares(std::int32_t number, const std::array<double, D>& weight,
                                      std::vector<Share>& of_point) const {
  constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
  std::array<std::span<const Share>, D> rest;
  for (int v = 0; v < D; ++v) {
    if (weight[v] != 0) rest[v] = shares(facet[number][v]);
  }
  for (;;) {
    std::int32_t next = none;
    for (const auto& of_corner : rest) {
      if (!of_corner.empty()) next = std::min(next, of_corner.front().slot);
    }
    if (next == none) return;
    double sum = 0;
    for (int v = 0; v < D; ++v) {
      if (rest[v].empty() || rest[v].front().slot != next) continue;
      sum += weight[v] * rest[v].front().weight;
      rest[v] = rest[v].subspan(1);
    }
    of_point.push_back({next, sum});
  }
}

/// Scales `v` to length 1 unless it is 0; returns its former length.
template <int D>
double normalise(Point<D>& v) {
  const double length = std::sqrt(dot<D>(v, v));
  for (double& component : v) component /= length > 0 ? length : 1;
  return length;
}

}  // namespace pliant::undeformed
