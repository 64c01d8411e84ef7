#pragma once

#include <span>
#include <vector>

#include "engine/geometry/shape.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// The faces of a shape: the surfaces of its balls, cylinders, half-spaces and meshes, and each
/// side of its boxes.
template <int D>
class Faces {
 public:
  /// Keeps a reference to `shape`; `spacing` [m] of the nodes sets the length scale.
  Faces(const Shape& shape, double spacing);

  /// The faces onto which the lattice point `x` can be moved, within half of `pitch` [m], or to an
  /// edge or a corner in its cell: as many as meet in a point of the surface. Empty where the
  /// surface is farther away.
  std::vector<int> near(const Point<D>& x, const Point<D>& pitch) const;

  /// The point nearest to `x` on all of these faces. A point that lies on them stays bitwise the
  /// same.
  Point<D> onto(Point<D> x, std::span<const int> faces) const;

  /// Whether `x` lies on the surface of the shape.
  bool hold(const Point<D>& x) const;

  /// The faces through the point `x`.
  std::vector<int> through(const Point<D>& x) const;

  /// The faces through `x`, or else the face nearest to it, if `x` is within half of the spacing of
  /// it and the place next to `x` on it is one of the surface.
  std::vector<int> through_or_near(const Point<D>& x) const;

  /// Whether these faces are planes.
  bool are_planes(std::span<const int> faces) const;

  /// Whether these faces meet in `x`, a point of the surface.
  bool meet(const Point<D>& x, std::span<const int> faces) const;

 private:
  void collect(const Shape& shape);
  bool is_on(int face, const Point<D>& x) const;

  const Shape& shape_;
  double spacing_;
  std::vector<Shape> face_;
};

extern template class Faces<2>;
extern template class Faces<3>;

}  // namespace pliant::point_based
