#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/lattice/layout.hpp"

namespace pliant::remeshed {

/// phi continued linearly behind walls that a body is attached to: there it describes where the
/// free surface would run on. At contact walls the body ends, (RP.54).
template <class T, int D>
class WallExtension {
 public:
  /// Nodes where `valid` is 0 got no phi from remeshing; they have the distance `far` [m].
  WallExtension(const Lattice<D>& lattice, const Layout<D>& layout, const T* phi, const T* valid,
                double far)
      : lattice_(lattice), layout_(layout), phi_(phi), valid_(valid), far_(far) {}

  /// phi of a block's nodes, continued, into `extended`.
  void extend(const Block<D>& block, const Boundaries<D>& boundaries, T* extended) const;

 private:
  double behind_wall(const Point<D>& x, const Point<D>& normal, double depth) const;
  bool interpolate(const Point<D>& x, double& value) const;

  const Lattice<D>& lattice_;
  const Layout<D>& layout_;
  const T* phi_;
  const T* valid_;
  double far_;
};

extern template class WallExtension<double, 2>;
extern template class WallExtension<double, 3>;
extern template class WallExtension<float, 2>;
extern template class WallExtension<float, 3>;

}  // namespace pliant::remeshed
