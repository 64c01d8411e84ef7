#pragma once

#include "kernels/second_piola.hpp"
#include "kernels/total_lagrangian/cell_energy.hpp"
#include "kernels/total_lagrangian/corner_modes.hpp"
#include "kernels/total_lagrangian/hourglass.hpp"

/// Functions for the stress points of both regular and fitted cells.
namespace pliant::kernels {

/// Square of an upper bound of the largest singular value: the largest row sum times the largest
/// column sum.
template <class P, int D>
inline P norm2_bound(const P (&matrix)[D * D]) {
  P row(Scalar<P>(0)), column(Scalar<P>(0));
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    P of_row = xsimd::abs(matrix[D * i]), of_column = xsimd::abs(matrix[i]);
#pragma GCC unroll 3
    for (int j = 1; j < D; ++j) {
      of_row = of_row + xsimd::abs(matrix[D * i + j]);
      of_column = of_column + xsimd::abs(matrix[D * j + i]);
    }
    row = xsimd::max(row, of_row);
    column = xsimd::max(column, of_column);
  }
  return row * column;
}

/// Displacement modes of the cells of a register, [component][mode].
template <class P, int D>
inline void displacement_modes(const Motion<Scalar<P>, D>& block, const CellRun<D>& run,
                               std::int64_t slot, P (&mode)[D][1 << D]) {
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    const Scalar<P>* d = block.displacement[i] + slot;
#pragma GCC unroll 8
    for (int c = 0; c < (1 << D); ++c) mode[i][c] = load<P>(d + run.row[c >> 1] + (c & 1));
    to_modes<P, D>(mode[i]);
  }
}

/// What a register of stress points contributes to the result of the block.
template <class P>
struct StressPointExtremes {
  P wave_speed2 = P(Scalar<P>(0));
  std::int64_t non_finite = -1;
};

/// Upper bound of c_X^2 of (TL.9) in units of the lattice, from |A^-1 F^-1|, given by `reverse` =
/// A^-1 cof F^T, and |A^-1|^2, given by `inverse2`. `networks` is the contribution of (TL.24) to
/// c^2.
template <ElasticLaw law, class P, int D>
inline P lattice_wave_speed2(const HyperelasticMaterial<Scalar<P>>& material,
                             const CellState<P, D>& state, const CellStress<P, D>& stress,
                             const P& networks, const P (&reverse)[D * D], const P& inverse2) {
  if constexpr (law == ElasticLaw::reduced_polynomial) {
    const P jacobian = state.volume_ratio;
    const P c2 = cell_wave_speed2<P, D>(material.polynomial, state, stress.excess) + networks;
    return c2 * norm2_bound<P, D>(reverse) / (jacobian * jacobian);
  } else {
    return wave_modulus<law, P, D>(material, state.f) * inverse2 / P(material.density);
  }
}

/// Returns the lanes whose stress is not finite or whose J <= 0; the wave speeds of the others
/// enter `extremes`.
template <class P, int D>
inline auto examine(const CellState<P, D>& state, const CellStress<P, D>& stress, const P& c2,
                    const typename P::batch_bool_type& inside, StressPointExtremes<P>& extremes) {
  const P zero(Scalar<P>(0));
  P finite = zero;
  for (const P& component : stress.piola) finite = fused(component, zero, finite);
  const auto sound = (finite == zero) && (state.volume_ratio > zero);
  extremes.wave_speed2 = xsimd::max(extremes.wave_speed2, xsimd::select(inside && sound, c2, zero));
  return inside && !sound;
}

}  // namespace pliant::kernels
