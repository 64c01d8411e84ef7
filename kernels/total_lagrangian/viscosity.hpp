#pragma once

#include "kernels/total_lagrangian/cell_energy.hpp"

/// Relaxation of the pressures at the stress points of a register of cells, (RP.10). `Slots` reads
/// and writes the values of these cells: regular cells are contiguous, fitted cells are not.
namespace pliant::kernels {

/// The sum of the p_i, advanced by (RP.22).
template <class P, int D, class Slots>
[[gnu::always_inline]] inline P relax_pressures(const CellViscosity<Scalar<P>>& viscosity,
                                                const CellState<P, D>& state, const Slots& slots) {
  using T = Scalar<P>;
  P sum(T(0));
  if (viscosity.terms == 0) return sum;
  const P start = slots.get(viscosity.volume_change), end = state.volume_ratio - P(T(1));
  for (int i = 0; i < viscosity.terms; ++i) {
    const P before = slots.get(viscosity.pressure[i]);
    const P after = relax_term(viscosity.relaxation[i], before, start, end);
    slots.put(viscosity.next_pressure[i], after, before);
    sum = sum + after;
  }
  slots.put(viscosity.next_volume_change, end, start);
  return sum;
}

}  // namespace pliant::kernels
