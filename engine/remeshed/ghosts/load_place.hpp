#pragma once

#include <Eigen/Core>

#include "engine/lattice/column.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "kernels/remeshed/ghosts/ghost_state.hpp"

namespace pliant::remeshed {

/// Where the load on a ghost is taken from.
template <class T, int D>
class LoadPlace {
 public:
  /// Its present foot point [m].
  explicit LoadPlace(const Point<D>& foot) : foot_(column<D>(foot)) {}

  /// Where a load that is linear along a face has the value that the constrained fit of ghost g
  /// takes it to have at all of its particles, (RP.113).
  LoadPlace(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
            const kernels::GhostFits<T, D>& fits, const Point<D>& foot)
      : foot_(column<D>(foot)) {
    for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
      const FittedParticle<T, D> particle(ghosts, g, k);
      const T phi = body.population.surface_distance[kernels::record_of(ghosts.pairs[k])];
      const double b = kernels::fit_coefficients(particle.terms, particle.r, phi).constrained;
      for (int a = 0; a < D; ++a) shift_[a] += b * particle.r[a];
    }
    shift_ *= body.lattice.spacing / (fits.constrained_sum - 1);
  }

  /// On a face with this unit normal [m].
  Point<D> on_face(const Column<D>& n) const {
    return as_point<D>(foot_ + shift_ - n.dot(shift_) * n);
  }

 private:
  Column<D> foot_, shift_ = Column<D>::Zero();  // [m]
};

}  // namespace pliant::remeshed
