#pragma once

#include <array>
#include <vector>

#include "engine/lattice/layout.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// Moves nodes to the zero set of a slot field, (RP.41). Positions are in cells.
///
/// They are relative to a nearby cell, since in single precision a position relative to a distant
/// cell has few digits.
template <class T, int D>
class Projections {
 public:
  /// Removes all nodes; those added later must be near the cell `nearby`.
  void clear(const Cell<D>& nearby);
  void add(std::int64_t slot, const Cell<D>& node, const Point<D>& start);

  /// Keeps the nodes for which new_start(i, start) is true, with these starts.
  template <class F>
  void restart(F&& new_start) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      Point<D> start;
      if (!new_start(i, start)) continue;
      slot_[kept] = slot_[i];
      for (int a = 0; a < D; ++a) {
        node_[a][kept] = node_[a][i];
        point_[a][kept] = static_cast<T>(start[a] - origin_[a]);
      }
      ++kept;
    }
    slot_.resize(kept);
    for (int a = 0; a < D; ++a) {
      node_[a].resize(kept);
      point_[a].resize(kept);
    }
  }

  /// Moves all points onto the zero set of `values`. Points that would move more than
  /// `farthest_move` cells out of the box around all starts may not converge.
  void run(const Lattice<D>& lattice, const Layout<D>& layout, const T* values, int farthest_move,
           int iterations, const kernels::RemeshedTable<T, D>& kernels);

  std::size_t size() const { return slot_.size(); }
  std::int64_t slot(std::size_t i) const { return slot_[i]; }
  Cell<D> cell(std::size_t i) const;
  Point<D> node(std::size_t i) const { return point_of(node_, i); }
  /// The start; after `run`, the result.
  Point<D> point(std::size_t i) const { return point_of(point_, i); }
  bool has_converged(std::size_t i) const { return converged_[i] != 0; }

 private:
  using Coordinates = std::array<std::vector<T>, D>;

  Point<D> point_of(const Coordinates& x, std::size_t i) const {
    Point<D> point;
    for (int a = 0; a < D; ++a) point[a] = origin_[a] + static_cast<double>(x[a][i]);
    return point;
  }
  void fill_box(const Lattice<D>& lattice, const Layout<D>& layout, const T* values,
                int farthest_move);
  void fill_row(const Lattice<D>& lattice, const Layout<D>& layout, const T* values,
                const Cell<D>& first, T* row) const;

  std::vector<std::int64_t> slot_;
  Coordinates node_, point_;
  std::vector<T> converged_;
  Cell<D> origin_ = {};  ///< origin of positions
  Cell<D> lower_, extent_;
  std::vector<T> box_;  ///< [z][y][x] values of the nodes around all starts
};

extern template class Projections<double, 2>;
extern template class Projections<double, 3>;
extern template class Projections<float, 2>;
extern template class Projections<float, 3>;

}  // namespace pliant::remeshed
