#pragma once

#include <span>
#include <vector>

#include "engine/undeformed/contact/moving_surface.hpp"

namespace pliant::undeformed {

/// The first stage of contact search: pairs of a patch of corners and a patch of facets that are
/// near each other, and how far the two patches of a pair may still move against each other.
///
/// A pair is listed if its patches are so near that facets have to be listed for its corners. All
/// distances are those at the marks of the two surfaces.
template <class T, int D>
class PatchPairs {
 public:
  struct Pair {
    std::int32_t corners, facets;
    double room;     ///< motion against each other that is left before the next marks [m]
    bool is_listed;  ///< whether facets are listed for its corners
  };

  /// `reach` is the largest depth behind a facet at which a corner is found [m]. Keeps references.
  PatchPairs(MovingSurface<T, D>& corners, MovingSurface<T, D>& facets, double reach);

  /// Whether all pairs have room for the motion that the surfaces have read. Pairs patches again if
  /// unpaired patches may have come near each other.
  bool hold();
  /// Announces new marks of both surfaces.
  void expect_marks();
  /// Computes the rooms at new marks; pairs patches again if the marks are `foreign`.
  void measure(bool foreign);

  /// The pairs, in ascending order of the patches of corners.
  std::span<const Pair> pairs() const { return pairs_; }
  /// How far the patches of listed pairs may move against each other between two marks [m].
  double margin() const { return margin_; }
  /// Box of the corners of a patch at the marks.
  const Box<D>& box_of_corners(std::int32_t patch) const { return box_[patch]; }
  /// Largest motion that `hold` has seen of a patch of corners against the facets listed for it
  /// [m].
  double moved(std::int32_t patch) const { return moved_[patch]; }
  /// The largest of these motions [m].
  double most_moved() const { return most_moved_; }

 private:
  double motion_in_common_frame() const;
  Box<D> marked_box_of_corners(std::size_t patch) const;
  Box<D> marked_box_of_facets(std::size_t patch) const;
  void pair_patches();
  void find_rooms();

  MovingSurface<T, D>& corners_;
  MovingSurface<T, D>& facets_;
  double reach_;
  double margin_;
  double wide_ = 0;                      ///< motion of unpaired patches before the next pairing [m]
  double used_ = 0;                      ///< part of it that was used up to the marks [m]
  std::vector<Box<D>> box_, other_box_;  ///< [patch] of corners, of facets, at the marks
  std::vector<Pair> pairs_;              ///< ascending
  std::vector<std::int32_t> paired_, paired_others_;  ///< patches of corners, of facets, in pairs
  std::vector<double> moved_;                         ///< [patch of corners]
  double most_moved_ = 0;
};

extern template class PatchPairs<double, 2>;
extern template class PatchPairs<double, 3>;
extern template class PatchPairs<float, 2>;
extern template class PatchPairs<float, 3>;

}  // namespace pliant::undeformed
