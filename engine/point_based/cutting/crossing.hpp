#pragma once

#include <optional>
#include <span>

#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// Where bonds cross one piece of a cut. Nodes lie on one of two sides of the plane of the piece;
/// those on the plane, up to rounding, count as the side that the normal with a positive first
/// component points to, whichever way the blade went: two cuts of one plane take them to the same
/// side. The boundary of the piece belongs to it, so that no bond slips through between two pieces.
template <int D>
class PieceCrossing {
 public:
  explicit PieceCrossing(const std::array<MaterialPoint<D>, D>& piece);

  /// Where the bond from `p` to `q` crosses the piece, if it does.
  std::optional<MaterialPoint<D>> operator()(const MaterialPoint<D>& p,
                                             const MaterialPoint<D>& q) const;

 private:
  std::array<MaterialPoint<D>, D> piece_;
  MaterialPoint<D> normal_;  ///< its first component that is not zero is positive
  double slack_;  ///< of distances along the normal, over the lengths that they are made of
};

/// The same of one bond.
template <int D>
std::optional<MaterialPoint<D>> crossing(const MaterialPoint<D>& p, const MaterialPoint<D>& q,
                                         const std::array<MaterialPoint<D>, D>& piece) {
  return PieceCrossing<D>(piece)(p, q);
}

/// The crossing of the way from `from` to `to` with cuts that is nearest to `from`, if there is
/// one.
template <int D>
std::optional<MaterialPoint<D>> first_crossing(const MaterialPoint<D>& from,
                                               const MaterialPoint<D>& to,
                                               std::span<const CutSurface<D>> cuts);

/// Distance [m] from `x` to a segment, which may have no length.
template <int D>
double distance_to_segment(const MaterialPoint<D>& x, const MaterialPoint<D>& a,
                           const MaterialPoint<D>& b);

/// Distance [m] from `x` to a piece, a segment in 2D and a triangle in 3D, and on which side it is.
template <int D>
struct PieceDistance {
  double distance = 0;
  double across = 0;  ///< signed distance to the line or plane of the piece
};
template <int D>
PieceDistance<D> distance_to_piece(const MaterialPoint<D>& x,
                                   const std::array<MaterialPoint<D>, D>& piece);

extern template class PieceCrossing<2>;
extern template class PieceCrossing<3>;

}  // namespace pliant::point_based
