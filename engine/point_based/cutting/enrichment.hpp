#pragma once

#include <vector>

#include "engine/point_based/cutting/cut_surface.hpp"

/// Distance enrichment of cuts: a number in [-1, 1] at each node. It is 1 on one face of the cut,
/// -1 on the other, and 0 far ahead of the cut. A bond between nodes with e_i and e_j keeps the
/// share (1 + e_i e_j)/2 of its weight, (CU.3).
namespace pliant::point_based {

/// (CU.4) for one piece: distance across it over distance to it. Zero beyond the end of a piece.
template <int D>
double piece_enrichment(const MaterialPoint<D>& x, const std::array<MaterialPoint<D>, D>& piece);

/// (CU.5): one enrichment for a whole cut. The cut is divided into regions along the chord from its
/// first station to its last. Unlike the product over pieces, it does not depend on the number of
/// pieces. In 3D a station is approximated by the segment between its end points, and places beside
/// the blade count as ahead of it.
template <int D>
class EnrichmentGrid {
 public:
  /// Throws std::invalid_argument when the stations do not advance along the chord, as in a
  /// hairpin: points would belong to the wrong region, and the cut would leak.
  explicit EnrichmentGrid(const CutSurface<D>& cut);

  double operator()(const MaterialPoint<D>& x) const;

 private:
  struct Region {
    MaterialPoint<D> origin, normal;          ///< unit normal of the cut in this region
    MaterialPoint<D> across_from, across_to;  ///< 3D: ends of the blade halfway, projected
  };
  MaterialPoint<D> chord_ = {};   ///< unit vector
  MaterialPoint<D> middle_ = {};  ///< place with t = 0
  std::vector<double> ends_;      ///< [station] t of its centre
  std::vector<Region> regions_;
};

extern template class EnrichmentGrid<2>;
extern template class EnrichmentGrid<3>;

}  // namespace pliant::point_based
