#pragma once

#include "engine/remeshed/body.hpp"
#include "kernels/remeshed/ghosts/fit_coefficients.hpp"

namespace pliant::remeshed {

/// Coefficient of (RP.43) of the k-th particle of all ghosts of a block, which is one of ghost g;
/// `polynomial` is `linear` or `surface` of its terms.
template <class T, int D>
T fit_coefficient(const BlockGhosts<T, D>& ghosts, std::size_t g, std::int64_t k,
                  const std::array<T, D + 1>& polynomial) {
  T r[D];
  for (int a = 0; a < D; ++a) {
    r[a] = kernels::cells_along(ghosts.pairs[k], a) + ghosts.terms[g].start[a];
  }
  return kernels::fit_weight(ghosts.terms[g], r) * kernels::linear_terms(polynomial, r);
}

}  // namespace pliant::remeshed
