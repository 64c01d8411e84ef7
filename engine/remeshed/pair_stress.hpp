#pragma once

#include "engine/remeshed/body.hpp"

/// Plain SPH, the paper's baseline: what its pair forces (RP.74) read.
namespace pliant::remeshed {

/// sigma/rho^2 and the artificial stress R of (RP.76) of a block's particles at a stage, into
/// `pair_stress`.
template <class T, int D>
void find_pair_stress(Body<T, D>& body, int block, int stage, double artificial_stress);

/// A view of them for the kernel, with the viscosity of (RP.75): beta = 2 alpha, c of the material
/// at rest.
template <class T, int D>
kernels::SymmetricPairs<T, D> symmetric_pairs(const Body<T, D>& body, double artificial_viscosity) {
  kernels::SymmetricPairs<T, D> pairs;
  for (int c = 0; c < kernels::symmetric_components<D>; ++c) {
    pairs.stress[c] = body.pair_stress[0][c].get();
    pairs.artificial[c] = body.pair_stress[1][c].get();
  }
  pairs.linear = static_cast<T>(artificial_viscosity) * kernels::wave_speed_at_rest(body.material);
  pairs.quadratic = static_cast<T>(2 * artificial_viscosity);
  return pairs;
}

extern template void find_pair_stress<double, 2>(Body<double, 2>&, int, int, double);
extern template void find_pair_stress<double, 3>(Body<double, 3>&, int, int, double);
extern template void find_pair_stress<float, 2>(Body<float, 2>&, int, int, double);
extern template void find_pair_stress<float, 3>(Body<float, 3>&, int, int, double);

}  // namespace pliant::remeshed
