#pragma once

#include "kernels/total_lagrangian/fitted_cells.hpp"

/// Stress points: corner displacements -> modes -> F -> first Piola-Kirchhoff stress -> forces,
/// mode by mode.
namespace pliant::kernels {

/// (RP.22) for a register of cells, where the body is.
template <class P, int D>
inline P relax_cells(const CellViscosity<Scalar<P>>& viscosity, const CellState<P, D>& state,
                     const typename P::batch_bool_type& inside, std::int64_t slot) {
  using T = Scalar<P>;
  P sum(T(0));
  if (viscosity.terms == 0) return sum;
  const P start = load<P>(viscosity.volume_change + slot), end = state.volume_ratio - P(T(1));
  for (int i = 0; i < viscosity.terms; ++i) {
    T* const kept = viscosity.pressure[i] + slot;
    const P before = load<P>(kept);
    const P after = relax_term(viscosity.relaxation[i], before, start, end);
    xsimd::select(inside, after, before).store_unaligned(kept);
    sum = sum + after;
  }
  xsimd::select(inside, end, start).store_unaligned(viscosity.volume_change + slot);
  return sum;
}

/// See StressPoints.
template <class P, int D>
StressPointsResult evaluate_stress_points(const StressPoints<Scalar<P>, D>& block) {
  using T = Scalar<P>;
  constexpr int corners = 1 << D;
  T volume = 1;
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) volume *= block.spacing;
  // Half the corners pull each way, so that a difference over h is 2/2^D of a gradient mode.
  const T slope = T(2) / (corners * block.spacing);
  const HourglassWeights<P, D> weights(block);
  StressPointExtremes<P> extremes;
  const P zero(T(0));
  for (int s = 0; s < block.segment_count; ++s) {
    const Segment<D>& segment = block.segments[s];
    std::int64_t row[corners / 2];
#pragma GCC unroll 4
    for (int r = 0; r < corners / 2; ++r) row[r] = corner_row<typename P::arch_type>(segment, r, 1);
    for (std::int64_t slot = segment.first; slot < segment.first + segment.count;
         slot += lanes<P>) {
      const P fraction = load<P>(block.fraction + slot);
      const auto inside = fraction > zero;
      if (!xsimd::any(inside)) {
#pragma GCC unroll 3
        for (int i = 0; i < D; ++i) {
          for (T* force : block.force[i]) zero.store_unaligned(force + slot);
        }
        continue;
      }
      P mode[D][corners];
      displacement_modes<P, D>(block, row, slot, mode);
      CellState<P, D> state;
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
        for (int j = 0; j < D; ++j) {
          // Corners of cells outside the body are nothing in particular.
          state.f[D * i + j] = xsimd::select(inside, mode[i][1 << j] * P(slope), zero);
        }
        state.f[D * i + i] = state.f[D * i + i] + P(T(1));
      }
      state.hourglass = xsimd::select(inside, hourglass_squares<P, D>(weights, mode), zero);
      state.complete();
      const P filled = P(volume) * fraction;
      const P pressure = relax_cells<P, D>(block.viscosity, state, inside, slot);
      const CellStress<P, D> stress = cell_stress<P, D>(block.material, state, pressure);
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
#pragma GCC unroll 8
        for (int m = 1; m < corners; ++m) {
          if (directions_of[m] < 2) continue;
          const P force = filled * stress.shear * P(weights.of[directions_of[m]]) * mode[i][m];
          xsimd::select(inside, force, zero).store_unaligned(block.force[i][m - 1] + slot);
        }
#pragma GCC unroll 3
        for (int j = 0; j < D; ++j) {
          (filled * P(slope) * stress.piola[D * i + j])
              .store_unaligned(block.force[i][(1 << j) - 1] + slot);
        }
      }
      if (!block.examine) continue;
      const auto broken = examine<P, D>(block.material, state, stress, state.cof, inside, extremes);
      if (extremes.non_finite < 0 && xsimd::any(broken)) {
        extremes.non_finite = slot + first_lane<P>(broken);
      }
    }
  }
  evaluate_fitted_cells<P, D>(block, extremes);
  return {square_root<P>(largest(extremes.wave_speed2)), extremes.non_finite};
}

}  // namespace pliant::kernels
