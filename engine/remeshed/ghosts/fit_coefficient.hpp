#pragma once

#include "engine/remeshed/state/body.hpp"
#include "kernels/remeshed/ghosts/fit_coefficients.hpp"

namespace pliant::remeshed {

/// A particle in the fits of ghost g; `k` numbers the particles of all ghosts of the block.
template <class T, int D>
struct FittedParticle {
  const kernels::FitTerms<T, D>& terms;
  T r[D];  ///< relative to the foot point, over h

  FittedParticle(const BlockGhosts<T, D>& ghosts, std::size_t g, std::int64_t k)
      : terms(ghosts.terms[g]) {
    for (int a = 0; a < D; ++a) r[a] = kernels::cells_along(ghosts.pairs[k], a) + terms.start[a];
  }

  /// (1 - r^2/R^2)^2
  T weight() const { return kernels::fit_weight(terms, r); }
};

/// Coefficient of (RP.43) of a particle; `polynomial` is `linear` or `surface` of the ghost's
/// terms.
template <class T, int D>
T fit_coefficient(const BlockGhosts<T, D>& ghosts, std::size_t g, std::int64_t k,
                  const std::array<T, D + 1>& polynomial) {
  const FittedParticle<T, D> particle(ghosts, g, k);
  return particle.weight() * kernels::linear_terms(polynomial, particle.r);
}

}  // namespace pliant::remeshed
