#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/blocks/box_tree.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/point_based/cutting/crossing.hpp"

namespace pliant::point_based {

/// All pieces of the cuts of a body, for queries along lines through the undeformed body.
template <int D>
class CutPieces {
 public:
  explicit CutPieces(std::span<const CutSurface<D>> cuts);

  struct Crossed {
    Point<D> place;   ///< [m]
    Point<D> normal;  ///< unit vector
    std::int32_t cut;
  };
  /// Where cuts cross the line from `p` to `q`, in the order of the cuts and their pieces.
  std::vector<Crossed> crossings(const Point<D>& p, const Point<D>& q) const;
  /// Whether a cut, except number `but`, lies between `p` and `q`.
  bool separate(const Point<D>& p, const Point<D>& q, std::int32_t but = -1) const;

  /// Boxes of parts of the pieces; no part is longer than `length` [m].
  std::vector<Box<D>> boxes(double length) const;

 private:
  struct Piece {
    std::array<Point<D>, D> corners;
    PieceCrossing<D> crossing;
    std::int32_t cut;
  };
  std::vector<Piece> pieces_;
  BoxTree<D> tree_;  ///< [piece]
};

extern template class CutPieces<2>;
extern template class CutPieces<3>;

}  // namespace pliant::point_based
