#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// [axis] the distance between lattice points: the one next to `spacing` [m] that divides the
/// extent of a shape.
template <int D>
Point<D> lattice_pitch(const Shape& shape, double spacing);

/// The signed distances of a shape at the points of the lattice of its nodes, which has one layer
/// more on each side than the box of the shape, and what the shape fills of the cells between them.
template <int D>
class BodyLattice {
 public:
  static constexpr int corners = 1 << D;
  static constexpr int sub_cells = 6;  ///< to a side of a cell; even: none lies between two points

  /// Keeps a reference to `shape`.
  BodyLattice(const Shape& shape, double spacing);

  const Point<D>& pitch() const { return pitch_; }
  double cell_volume() const;
  /// The last point, or with `less` = 1 the last cell; the first is {}.
  Cell<D> last(int less) const;
  std::int64_t points() const { return static_cast<std::int64_t>(phi_.size()); }
  std::int64_t index(const Cell<D>& point) const;
  /// Of corner `c` of a cell, bit a for the upper side along axis a.
  std::int64_t corner(const Cell<D>& cell, int c) const;
  Point<D> place(const Cell<D>& point) const;
  /// [spacing] exact below 2; points on the surface have 0.
  double distance(const Cell<D>& point) const { return distance_at(index(point)); }
  double distance_at(std::int64_t point) const { return phi_[point]; }

  /// What a shape fills of a cell.
  enum class Filling { none, part, all };
  Filling filling(const Cell<D>& cell) const;
  /// [sub-cell, x fastest] the share of each sub-cell of a cell that the shape fills.
  std::vector<double> filled(const Cell<D>& cell) const;
  /// The middle of a sub-cell.
  Point<D> middle(const Cell<D>& cell, int sub_cell) const;

 private:
  /// Of the sub-cell about `x`.
  double filled_at(const Cell<D>& cell, const Point<D>& x) const;
  /// Of phi along the normal of the surface, through the sub-cell about `x` [spacing].
  double change_across(const Cell<D>& cell, const Point<D>& x) const;
  /// phi at a place of a cell [spacing].
  double distance_in(const Cell<D>& cell, const Point<D>& x) const;
  double between(const Cell<D>& cell, const Point<D>& x) const;

  const Shape& shape_;
  double spacing_;
  bool has_mesh_;
  Point<D> pitch_, start_;
  Cell<D> extent_;
  std::array<std::int64_t, D> stride_;
  std::vector<double> phi_;
};

extern template Point<2> lattice_pitch<2>(const Shape&, double);
extern template Point<3> lattice_pitch<3>(const Shape&, double);
extern template class BodyLattice<2>;
extern template class BodyLattice<3>;

}  // namespace pliant::point_based
