#pragma once

#include <optional>
#include <span>

#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// Where bonds cross one piece of a cut. The plane of the piece divides the nodes into two sides. A
/// node on the plane, up to rounding, counts to the side of the normal with positive first
/// component, whatever the direction of the blade: two cuts in one plane then agree about it. The
/// boundary belongs to the piece, so that no bond slips through between two pieces.
template <int D>
class PieceCrossing {
 public:
  explicit PieceCrossing(const std::array<MaterialPoint<D>, D>& piece);

  /// Where the bond from `p` to `q` crosses the piece; none if it does not.
  std::optional<MaterialPoint<D>> operator()(const MaterialPoint<D>& p,
                                             const MaterialPoint<D>& q) const;

 private:
  std::array<MaterialPoint<D>, D> piece_;
  MaterialPoint<D> normal_;  ///< its first non-zero component is positive
  double slack_;  ///< rounding of distances along the normal, relative to the lengths involved
};

/// The same for one bond.
template <int D>
std::optional<MaterialPoint<D>> crossing(const MaterialPoint<D>& p, const MaterialPoint<D>& q,
                                         const std::array<MaterialPoint<D>, D>& piece) {
  return PieceCrossing<D>(piece)(p, q);
}

/// The crossing of the line from `from` to `to` with a cut that is nearest to `from`; if any.
template <int D>
std::optional<MaterialPoint<D>> first_crossing(const MaterialPoint<D>& from,
                                               const MaterialPoint<D>& to,
                                               std::span<const CutSurface<D>> cuts);

/// Distance [m] from `x` to a segment; the segment may be a point.
template <int D>
double distance_to_segment(const MaterialPoint<D>& x, const MaterialPoint<D>& a,
                           const MaterialPoint<D>& b);

/// Distance [m] from `x` to a piece (2D: segment, 3D: triangle), and the side of it.
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
