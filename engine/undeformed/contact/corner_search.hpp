#pragma once

#include <span>
#include <utility>
#include <vector>

#include "engine/undeformed/contact/patch_pairs.hpp"

namespace pliant::undeformed {

/// A corner of one surface and the point of another surface that it touches.
template <int D>
struct Penetration {
  std::int32_t corner, facet;
  std::array<double, D> weight;  ///< of the facet's corners at that point
  Point<D> normal;               ///< from the corner to that point, out of the other body
  double gap;                    ///< [m], negative
};

/// Finds the corners of one surface that have entered another one, which may belong to the same
/// body.
///
/// Marks record where both surfaces were when the facets near each corner were listed. The lists
/// are valid until two patches have moved against each other by more than they may, (TL.20). So the
/// result depends only on where the surfaces are.
template <class T, int D>
class CornerSearch {
 public:
  /// Keeps references to both surfaces.
  CornerSearch(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets);

  /// Whether the lists are valid for the motion that the surfaces have read.
  bool holds() { return pairs_.hold(); }
  /// Announces new marks of both surfaces.
  void expect_marks() { pairs_.expect_marks(); }
  /// Makes new lists, from the marks; also pairs patches again if the marks are `foreign`.
  void list(bool foreign);
  /// Makes the surfaces watch the corners and facets of the lists.
  void watch();

  /// Whether a corner may touch after the motion that `holds` has seen.
  bool may_find() const { return least_clearance_ <= pairs_.most_moved(); }
  /// Number of corners that may touch before the next lists.
  std::size_t candidates() const { return corner_.size(); }
  /// Appends the touches of the candidates `first` to `end` - 1, in the order of the patches of
  /// corners, (TL.15).
  void find(std::size_t first, std::size_t end, std::vector<Penetration<D>>& touches) const;

 private:
  using Pair = typename PatchPairs<T, D>::Pair;
  /// A facet that a corner may be near.
  struct Near {
    std::int32_t facet;
    double distance;  ///< at the marks; a lower bound [m]
  };

  void list_patch(std::span<const Pair> pairs_of_patch);
  void list_corner(std::int32_t corner, std::int32_t patch);
  bool finds(std::size_t candidate, double moved, Penetration<D>& touch) const;
  bool are_neighbours(std::int32_t corner, const std::array<std::int32_t, D>& facet) const;

  MovingSurface<T, D>& corners_;
  MovingSurface<T, D>& facets_;
  bool same_;       ///< whether both surfaces are the same
  double deepest_;  ///< largest depth of a corner behind a facet [m]
  PatchPairs<T, D> pairs_;
  std::vector<std::int32_t> corner_;  ///< candidates
  std::vector<std::int32_t> patch_;   ///< [candidate] patch of the corner
  std::vector<double> clearance_;     ///< [candidate] motion before it can touch [m]
  double least_clearance_ = 0;        ///< smallest clearance [m]
  std::vector<std::size_t> begin_;    ///< [candidate + 1] into near_
  std::vector<Near> near_;            ///< of each candidate, by distance
  std::vector<std::pair<std::int32_t, Box<D>>>
      near_facets_;            ///< of one patch, while lists are made
  std::vector<Near> reached_;  ///< of one corner
};

extern template class CornerSearch<double, 2>;
extern template class CornerSearch<double, 3>;
extern template class CornerSearch<float, 2>;
extern template class CornerSearch<float, 3>;

}  // namespace pliant::undeformed
