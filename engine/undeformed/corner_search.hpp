#pragma once

#include <vector>

#include "engine/undeformed/moving_surface.hpp"

namespace pliant::undeformed {

/// A corner of one surface that lies behind a facet of another one.
template <int D>
struct Touch {
  std::int32_t corner, facet;
  std::array<double, D> weight;  ///< of the facet's corners at the nearest point of the surface
  Point<D> normal;               ///< from the corner to that point, out of the other body
  double gap;                    ///< [m], negative
};

/// Weights of the corners of a segment or a triangle at its point nearest to `x`.
std::array<double, 2> nearest_weights(const std::array<Point<2>, 2>& c, const Point<2>& x);
std::array<double, 3> nearest_weights(const std::array<Point<3>, 3>& c, const Point<3>& x);

/// Finds the corners of one surface that have entered another one, which may be of the same body.
///
/// What is found is a function of where the surfaces are: lists of facets near each corner, which
/// last until the surfaces have moved by a margin, only save looking at the others.
template <class T, int D>
class CornerSearch {
 public:
  /// Keeps references to both.
  CornerSearch(const MovingSurface<T, D>& corners, const MovingSurface<T, D>& facets);

  /// Lists anew, where the surfaces have just been marked; returns how far they may then move, both
  /// together [m].
  double list();

  /// Whether a corner may touch where the surfaces have moved by `moved` since the list, both
  /// together [m].
  bool may_find(double moved) const { return least_clearance_ <= moved; }
  /// Lets the surfaces watch what the search looks at.
  void watch(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets) const;
  /// Corners that have facets near them.
  std::size_t candidates() const { return corner_.size(); }
  /// Appends what touches of the candidates from number `first` to before `end`, in the order of
  /// the corners: (TL.15). The surfaces have moved by `moved` since the list, both together [m].
  void find(double moved, std::size_t first, std::size_t end, std::vector<Touch<D>>& touches) const;

 private:
  bool finds(std::int32_t corner, std::span<const std::int32_t> facets, Touch<D>& touch) const;
  bool are_neighbours(std::int32_t corner, const std::array<std::int32_t, D>& facet) const;

  const MovingSurface<T, D>& corners_;
  const MovingSurface<T, D>& facets_;
  bool same_;                         ///< whether both are one surface
  double deepest_;                    ///< of a corner behind a facet [m]
  std::vector<std::int32_t> corner_;  ///< those that have facets near them
  std::vector<std::size_t> begin_;    ///< [corner_ + 1] into near_
  std::vector<double> clearance_;     ///< [corner_] what surfaces must move before it touches [m]
  double least_clearance_ = 0;        ///< of all of them [m]
  std::vector<std::int32_t> near_;    ///< facets
};

extern template class CornerSearch<double, 2>;
extern template class CornerSearch<double, 3>;
extern template class CornerSearch<float, 2>;
extern template class CornerSearch<float, 3>;

}  // namespace pliant::undeformed
