#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/blocks/box.hpp"
#include "engine/geometry/shape.hpp"
#include "engine/lattice/inside_parts.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/undeformed/body.hpp"

namespace pliant::point_based {

/// Whether a facet of a surface with the spacing `h` [m] has an area.
template <int D>
bool has_area(const std::array<Point<D>, D>& corners, double h) {
  constexpr double smallest = 1e-9;  // [h^(D-1)]
  return norm<D>(undeformed::area_vector<D>(corners)) >= smallest * std::pow(h, D - 1);
}

/// A shape between the points of a lattice: the simplices that fill it, and the facets that bound
/// them.
template <int D>
class SurfaceLattice {
 public:
  /// The lattice is that of the nodes, `lattice_pitch`, so that points lie on all faces of a box.
  /// Points on the surface count as inside. Keeps a reference to the shape.
  SurfaceLattice(const Shape& shape, double spacing);

  /// Identifies a corner by the two lattice points that it lies between; at a lattice point, both
  /// are equal.
  using Name = std::pair<std::int64_t, std::int64_t>;
  struct Corner {
    Name name;
    Point<D> place;  ///< [m]
  };
  using Facet = std::array<Corner, D>;
  using Simplex = std::array<Corner, D + 1>;

  /// Facets of the surface, ordered as seen from outside.
  std::vector<Facet> facets() const;
  /// The simplices in all cells that touch one of the boxes. The determinant of their edges from
  /// the first corner is positive.
  std::vector<Simplex> simplices_near(const std::vector<Box<D>>& boxes) const;

 private:
  using Cube = std::array<SurfaceNode<D>, (1 << D)>;

  Point<D> place(const Cell<D>& cell) const;
  std::int64_t slot(const Cell<D>& cell) const;
  /// The corners of a cell, and how many of them are inside.
  std::pair<Cube, int> cube_at(const Cell<D>& cell) const;
  Corner corner(const Crossing<D>& crossing) const;

  const Shape* shape_ = nullptr;  ///< null where distances are expensive

  double spacing_;  ///< h of the case [m]
  Point<D> pitch_;  ///< distances of lattice points [m]
  Point<D> lower_ = {};
  Cell<D> extent_ = {};
  std::vector<double> phi_;  ///< [lattice point] [h]
};

extern template class SurfaceLattice<2>;
extern template class SurfaceLattice<3>;

}  // namespace pliant::point_based
