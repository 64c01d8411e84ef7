#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/undeformed/body.hpp"

/// The piece of a curved surface that a facet between lattice points represents, (PB.62).
///
/// The corners of a facet lie on straight lines between lattice points, where phi is linear. They
/// are inside a convex body, and so is the rest of the facet: the facets enclose too little. The
/// facet is divided into smaller ones, whose corners are put onto the surface. Facets with a common
/// side divide it alike. So the pieces of a closed surface are closed, and a pressure on all of
/// them has no resultant.
namespace pliant::undeformed {

/// Parts along a side of a facet.
inline constexpr int parts_to_a_side = 8;

template <int D>
struct CurvedPart {
  std::array<double, D> at = {};  ///< weights of the corners of the facet in the middle of the part
  Point<D> middle = {};           ///< on the surface [m]
  Point<D> area = {};             ///< area vector [m^(D-1)]
};

/// The place on the surface of `shape` next to `x`, or `x` if that is farther away than half of the
/// spacing `h` [m], and `x` itself where it lies on the surface.
template <int D>
Point<D> onto_surface(const Shape& shape, const Point<D>& x, double h) {
  constexpr double on_surface = 1e-9;  // [h]
  constexpr int most_steps = 8;
  Point<D> place = x;
  for (int i = 0; i < most_steps; ++i) {
    const double left = signed_distance(shape, padded<D>(place), D);
    if (std::abs(left) <= on_surface * h) return place;
    if (std::abs(left) > h / 2) return x;
    const Vector outward = outward_direction(shape, padded<D>(place), D);
    for (int a = 0; a < D; ++a) place[a] -= left * outward[a];
  }
  return x;
}

template <int D>
class CurvedFacet {
 public:
  /// A facet that is its piece of the surface.
  CurvedFacet() = default;
  CurvedFacet(const Shape& shape, const std::array<Point<D>, D>& corner, double h) {
    // The same order for both facets at a side, so that rounding is the same.
    for (int i = 0; i <= parts_to_a_side; ++i) {
      for (int j = 0; j <= (D == 2 ? 0 : i); ++j) {
        std::array<int, D> share = {};
        share[0] = parts_to_a_side - i;
        share[1] = i - j;
        if constexpr (D == 3) share[2] = j;
        const Point<D> x = between(corner, share);
        grid_.push_back(onto_surface<D>(shape, x, h));
        is_flat_ = is_flat_ && grid_.back() == x;
      }
    }
    if (is_flat_) return;
    divide();
    for (CurvedPart<D>& part : parts_) part.middle = onto_surface<D>(shape, part.middle, h);
  }

  /// Whether the facet lies on the surface.
  bool is_flat() const { return is_flat_; }
  /// Those of a facet that does not lie on the surface.
  const std::vector<CurvedPart<D>>& parts() const { return parts_; }
  /// The sum of their area vectors [m^(D-1)].
  Point<D> area() const {
    Point<D> sum = {};
    for (const CurvedPart<D>& part : parts_) {
      for (int a = 0; a < D; ++a) sum[a] += part.area[a];
    }
    return sum;
  }

 private:
  // Sums in the order of the places of the corners do not depend on the order of the corners.
  static Point<D> between(const std::array<Point<D>, D>& corner, const std::array<int, D>& share) {
    std::array<int, D> order;
    for (int v = 0; v < D; ++v) order[v] = v;
    std::sort(order.begin(), order.end(), [&](int v, int w) { return corner[v] < corner[w]; });
    Point<D> x = {};
    for (const int v : order) {
      if (share[v] == parts_to_a_side) return corner[v];
      for (int a = 0; a < D; ++a) x[a] += share[v] * corner[v][a];
    }
    for (double& component : x) component /= parts_to_a_side;
    return x;
  }

  void divide() {
    if constexpr (D == 2) {
      for (int i = 0; i < parts_to_a_side; ++i) {
        const double middle = (i + 0.5) / parts_to_a_side;
        add({i, i + 1}, {1 - middle, middle});
      }
    } else {
      const auto number = [](int i, int j) { return i * (i + 1) / 2 + j; };
      const auto at = [](double i, double j) -> std::array<double, 3> {
        return {1 - i / parts_to_a_side, (i - j) / parts_to_a_side, j / parts_to_a_side};
      };
      for (int i = 0; i < parts_to_a_side; ++i) {
        for (int j = 0; j <= i; ++j) {
          add({number(i, j), number(i + 1, j), number(i + 1, j + 1)}, at(i + 2. / 3, j + 1. / 3));
          if (j == i) continue;
          add({number(i, j), number(i + 1, j + 1), number(i, j + 1)}, at(i + 1. / 3, j + 2. / 3));
        }
      }
    }
  }

  void add(const std::array<int, D>& corner, const std::array<double, D>& at) {
    CurvedPart<D>& part = parts_.emplace_back();
    part.at = at;
    std::array<Point<D>, D> x;
    for (int v = 0; v < D; ++v) x[v] = grid_[corner[v]];
    part.middle = middle_of<D>(x);
    part.area = area_vector<D>(x);
  }

  std::vector<Point<D>> grid_;
  std::vector<CurvedPart<D>> parts_;
  bool is_flat_ = true;
};

}  // namespace pliant::undeformed
