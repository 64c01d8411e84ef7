#pragma once

#include "engine/remeshed/ghosts/surface_fits.hpp"
#include "engine/remeshed/level_set/level_set.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Finds the particles for the fits of ghosts.
template <class T, int D>
class FitSearch {
 public:
  FitSearch(const Lattice<D>& lattice, const Population<T, D>& population,
            const LevelSet<T, D>& level_set)
      : lattice_(lattice), population_(population), level_set_(level_set) {}

  /// The interior particles within reach of `centre` (in cells), row by row, with their distances
  /// from `wall`, or from the surface if that is nullptr.
  void find(const Point<D>& centre, const FitReach<D>& reach, const Wall<D>* wall,
            FitParticles<D>& particles) const;

 private:
  const Lattice<D>& lattice_;
  const Population<T, D>& population_;
  const LevelSet<T, D>& level_set_;
};

extern template class FitSearch<double, 2>;
extern template class FitSearch<double, 3>;
extern template class FitSearch<float, 2>;
extern template class FitSearch<float, 3>;

}  // namespace pliant::remeshed
