#pragma once

#include <vector>

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Cells, inclusive, to which the particles of a block are nearest; lower > upper without any.
template <int D>
struct CellBounds {
  Cell<D> lower, upper;
};

/// Cells around interior particles that have slots. Ghosts of a free surface lie within five cells,
/// but closest points (RP.41) of the nodes near it interpolate phi from nodes in the sixth. Where
/// the surface meets a wall, ghosts lie as deep behind the wall as beyond the surface, and the
/// corner is farther away: seven.
constexpr int layout_reach(bool has_walls) { return has_walls ? 7 : 6; }

/// Finds where a body needs slots: every cell within reach of an interior particle.
template <class T, int D>
class LayoutSearch {
 public:
  LayoutSearch(const Body<T, D>& body, bool has_walls)
      : body_(body), reach_(layout_reach(has_walls)) {}

  /// Once the body has other blocks.
  void prepare() { bounds_.resize(body_.population.layout.blocks().size()); }
  /// Block by block, then `mark_particles`.
  void find_bounds(int block);
  /// False where the particles have flown so far apart that no map of their cells fits into memory.
  bool mark_particles();
  /// In their place at t = 0: nodes inside the body's geometry.
  void mark_geometry();
  /// From a checkpoint.
  void restore(const std::vector<std::int32_t>& occupancy) { occupancy_.restore(occupancy); }

  void build(Layout<D>& layout) const;
  /// [present block]
  const std::vector<CellBounds<D>>& bounds() const { return bounds_; }

 private:
  /// Cells to each side that blocks can reach: a ghost, its foot point, its widest fit.
  static constexpr int block_reach = 10;

  /// Marks a cell of the first period, and what of its images lies within reach of that: the body
  /// beside one end of a period has ghosts beyond the other end.
  void mark_images(const Cell<D>& cell);

  const Body<T, D>& body_;
  int reach_;
  Occupancy<D> occupancy_;
  std::vector<CellBounds<D>> bounds_;
};

extern template class LayoutSearch<double, 2>;
extern template class LayoutSearch<double, 3>;
extern template class LayoutSearch<float, 2>;
extern template class LayoutSearch<float, 3>;

}  // namespace pliant::remeshed
