#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// [axis] the distance between lattice points: close to `spacing` [m], and such that it divides the
/// extent of the shape.
template <int D>
Point<D> lattice_pitch(const Shape& shape, double spacing);

/// The signed distances of a shape at the points of the lattice of its nodes, and the filling of
/// the cells between them. The lattice exceeds the box of the shape by a layer on each side.
template <int D>
class BodyLattice {
 public:
  static constexpr int corners = 1 << D;
  static constexpr int sub_cells =
      6;  ///< along a side of a cell; even, so that each is nearest to one corner

  /// Keeps a reference to `shape`.
  BodyLattice(const Shape& shape, double spacing);

  const Point<D>& pitch() const { return pitch_; }
  double cell_volume() const;
  /// The last point, or with `less` = 1 the last cell; the first one is {}.
  Cell<D> last(int less) const;
  std::int64_t points() const { return static_cast<std::int64_t>(phi_.size()); }
  std::int64_t index(const Cell<D>& point) const;
  /// Index of corner `c` of a cell; bit a is set on the upper side along axis a.
  std::int64_t corner(const Cell<D>& cell, int c) const;
  Point<D> place(const Cell<D>& point) const;
  /// [spacing] exact below 2; 0 on the surface.
  double distance(const Cell<D>& point) const { return distance_at(index(point)); }
  double distance_at(std::int64_t point) const { return phi_[point]; }

  /// How much of a cell the shape fills.
  enum class Filling { none, part, all };
  Filling filling(const Cell<D>& cell) const;
  /// [sub-cell, x fastest] the share of each sub-cell that the shape fills.
  std::vector<double> filled(const Cell<D>& cell) const;
  /// The middle of a sub-cell.
  Point<D> middle(const Cell<D>& cell, int sub_cell) const;

 private:
  /// Filled share of the sub-cell around `x`.
  double filled_at(const Cell<D>& cell, const Point<D>& x) const;
  /// Change of phi across the sub-cell around `x`, along the normal of the surface [spacing].
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
  std::vector<double> mean_phi_;  ///< for interpolation in meshes, (TL.33)
};

extern template Point<2> lattice_pitch<2>(const Shape&, double);
extern template Point<3> lattice_pitch<3>(const Shape&, double);
extern template class BodyLattice<2>;
extern template class BodyLattice<3>;

}  // namespace pliant::point_based
