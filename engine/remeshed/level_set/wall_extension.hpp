#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/lattice/layout.hpp"

namespace pliant::remeshed {

/// phi extended behind walls to which a body is attached, as the free surface would continue there:
/// mirrored at frictionless walls, and along lines with the curvature of the initial surface behind
/// the others. At contact walls the body ends, (RP.54).
template <class T, int D>
class WallExtension {
 public:
  /// `initial_surface` is the free surface at t = 0. `valid` is 0 at nodes without phi from
  /// remeshing; they get the distance `far` [m].
  WallExtension(const Lattice<D>& lattice, const Layout<D>& layout, const Shape& initial_surface,
                const T* phi, const T* valid, double far)
      : lattice_(lattice),
        layout_(layout),
        initial_surface_(initial_surface),
        phi_(phi),
        valid_(valid),
        far_(far) {}

  /// Writes phi of a block's nodes, extended, to `extended`.
  void extend(const Block<D>& block, const Boundaries<D>& boundaries, T* extended) const;

 private:
  double continued(const Point<D>& x, const Boundaries<D>& boundaries, int images) const;
  double along_line(const Point<D>& x, const Wall<D>& wall, double depth) const;
  bool interpolate(const Point<D>& x, double& value) const;

  const Lattice<D>& lattice_;
  const Layout<D>& layout_;
  const Shape& initial_surface_;
  const T* phi_;
  const T* valid_;
  double far_;
};

extern template class WallExtension<double, 2>;
extern template class WallExtension<double, 3>;
extern template class WallExtension<float, 2>;
extern template class WallExtension<float, 3>;

}  // namespace pliant::remeshed
