#pragma once

#include <vector>

#include "engine/blocks/cell_list.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/state/body.hpp"

/// Re-entrant corners of the free surface, (RP.109); see engine/geometry/reentrant_corner.hpp. The
/// stress is singular there.
namespace pliant::remeshed {

inline constexpr double corner_reach = 2.4;  ///< [h] of foot points that are beside a corner

/// Finds the corners near nodes of a block outside the body, once for each such node, from the
/// closest points of the nodes around it. Places are in m.
template <class T, int D>
void find_reentrant_corners(const Lattice<D>& lattice, const Population<T, D>& population,
                            const LevelSet<T, D>& level_set, int block,
                            std::vector<Point<D>>& corners);

/// The corners of a body, for distances from them.
template <int D>
class ReentrantCorners {
 public:
  /// From the corners that each block has found, for distances up to `reach` [m].
  void collect(const std::vector<std::vector<Point<D>>>& blocks, double reach);

  /// From x to the nearest corner [m], infinite where that is beyond the reach.
  double distance(const Point<D>& x) const;

 private:
  std::size_t count_ = 0;
  double reach_ = 0;
  CellList<double, D> cells_;
};

extern template class ReentrantCorners<2>;
extern template class ReentrantCorners<3>;

}  // namespace pliant::remeshed
