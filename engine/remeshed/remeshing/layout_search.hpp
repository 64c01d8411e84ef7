#pragma once

#include <vector>

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Inclusive bounds of the cells nearest to the particles of a block; lower > upper if there are
/// none.
template <int D>
struct CellBounds {
  Cell<D> lower, upper;
};

/// Distance in cells from interior particles up to which cells have slots. Ghosts of a free surface
/// are within five cells, but closest points (RP.41) interpolate phi from nodes in the sixth.
/// Ghosts in the corner between surface and wall are farther away: seven.
constexpr int layout_reach(bool has_walls) { return has_walls ? 7 : 6; }

/// Finds the slots that a body needs: every cell within reach of an interior particle.
template <class T, int D>
class LayoutSearch {
 public:
  LayoutSearch(const Body<T, D>& body, bool has_walls)
      : body_(body), reach_(layout_reach(has_walls)) {}

  /// Called when the blocks of the body have changed.
  void prepare() { bounds_.resize(body_.population.layout.blocks().size()); }
  /// Called block by block, before `mark_particles`.
  void find_bounds(int block);
  /// False if the particles are so far apart that a map of their cells does not fit into memory.
  bool mark_particles();
  /// At t = 0, instead of these: marks nodes inside the body's geometry.
  void mark_geometry();
  /// Restores the marks from a checkpoint.
  void restore(const std::vector<std::int32_t>& occupancy) { occupancy_.restore(occupancy); }

  void build(Layout<D>& layout) const;
  /// [present block]
  const std::vector<CellBounds<D>>& bounds() const { return bounds_; }

 private:
  /// Distance in cells that blocks can read: a ghost, its foot point, its widest fit.
  static constexpr int block_reach = 10;

  /// Marks a cell of the first period, and its images within reach of that: a body at one end of a
  /// period has ghosts beyond the other end.
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
