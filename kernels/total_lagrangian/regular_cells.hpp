#pragma once

#include <algorithm>

#include "kernels/shifted_lanes.hpp"
#include "kernels/total_lagrangian/cell_forces.hpp"

/// Stress points of cells whose corners are on the lattice: corner displacements -> modes -> F ->
/// first Piola-Kirchhoff stress -> forces, mode by mode -> corner forces -> sums over the cells
/// around a particle.
///
///     cells of row y    | A | B | C | D |      A register of cells has forces on rows of corners:
///                       /\  /\  /\  /\         at its own slots (lower corners in x) and at the
///     corners, row r    a   b   c   d   e      next ones (upper corners), which are shifted by one
///                                              lane, with the last cell of the register before.
namespace pliant::kernels {

/// The slots of a register of cells; values are written inside the body.
template <class P>
struct RegularSlots {
  using T = Scalar<P>;
  std::int64_t slot;
  typename P::batch_bool_type inside;
  bool keep;  ///< whether the cells belong to the block, which then writes them

  P get(const T* from) const { return load<P>(from + slot); }
  void put(T* to, const P& value, const P& before) const {
    if (keep) xsimd::select(inside, value, before).store_unaligned(to + slot);
  }
};

/// F and the other arguments of the energy, (TL.2). Outside the body, where corners hold arbitrary
/// values, F = I. The hourglass modes are replaced by half the derivatives of Q, (TL.6).
template <class P, int D>
inline void regular_state(const HourglassWeights<P, D>& weights, const P& slope,
                          const typename P::batch_bool_type& inside, P (&mode)[D][1 << D],
                          CellState<P, D>& state) {
  using T = Scalar<P>;
  const P zero(T(0)), slope_inside = xsimd::select(inside, slope, zero);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
#pragma GCC unroll 3
    for (int j = 0; j < D; ++j) state.f[D * i + j] = mode[i][1 << j] * slope_inside;
    state.f[D * i + i] = state.f[D * i + i] + P(T(1));
  }
  std::copy_n(state.f, D * D, state.by_f);
  const P squares = hourglass_squares<P, D>(weights, state.f, mode, state.by_f);
  state.hourglass = xsimd::select(inside, squares, zero);
  state.find_cofactor();
}

/// Forces on the upper corners in x of a register of cells, which the next register completes.
template <class P, int D>
struct UpperCorners {
  P force[D][corner_rows<D>];
  bool exist = false;

  void clear() {
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
#pragma GCC unroll 4
      for (int r = 0; r < corner_rows<D>; ++r) force[i][r] = P(Scalar<P>(0));
    }
    exist = false;
  }
};

/// Subtracts one component of the corner forces of a register of cells, `pull`, from the forces on
/// the particles. `along` is the offset from the first cell of the run.
template <class P, int D>
inline void subtract_forces(const CellRun<D>& run, std::int64_t along, const P (&pull)[1 << D],
                            P (&upper)[corner_rows<D>], Scalar<P>* force) {
#pragma GCC unroll 4
  for (int r = 0; r < corner_rows<D>; ++r) {
    const P both = pull[2 * r] + ShiftedLanes<P>::of(upper[r], pull[2 * r + 1]);
    upper[r] = pull[2 * r + 1];
    if (run.target[r] < 0 || along < 0) continue;
    Scalar<P>* const at = force + run.target[r] + along;
    (load<P>(at) - both).store_unaligned(at);
  }
}

/// Adds the upper corners after the last cell of the body in a row.
template <class P, int D>
inline void finish_row(const Motion<Scalar<P>, D>& block, const CellRun<D>& run, std::int64_t along,
                       UpperCorners<P, D>& upper) {
  const P zero(Scalar<P>(0));
  P nothing[1 << D];
#pragma GCC unroll 8
  for (P& pull : nothing) pull = zero;
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    subtract_forces<P, D>(run, along, nothing, upper.force[i], block.force[i]);
  }
  upper.exist = false;
}

/// Prefetches what the particles of a pack need to move, and what the next row of cells is the
/// first to read: too many arrays with short rows for the processor to prefetch.
template <class T, int D>
[[gnu::always_inline]] inline void prefetch_pack(const Motion<T, D>& block, const CellRun<D>& run,
                                                 std::int64_t slot) {
  constexpr int ahead = 8 * slots_per_pack, last = corner_rows<D> - 1;
  __builtin_prefetch(block.inverse_mass + slot);
  __builtin_prefetch(block.fraction + slot + ahead);
#pragma GCC unroll 3
  for (int i = 0; i < D; ++i) {
    __builtin_prefetch(block.displacement[i] + slot + run.row[last] + ahead);
    if (block.traction[i] != nullptr) __builtin_prefetch(block.traction[i] + slot);
    __builtin_prefetch(block.internal[i] + slot, 1);
    __builtin_prefetch(block.velocity[i] + slot, 1);
    __builtin_prefetch(block.next_displacement[i] + slot, 1);
  }
}

/// Subtracts the forces of a run of cells from `block.force`, (TL.3)-(TL.6), and (TL.24) if it
/// relaxes in shear; with (TL.36) if the surface cuts some of its cells. `of_runs` passes the upper
/// corners from one run to the next.
template <ElasticLaw law, bool relaxes, bool cut, class P, int D>
[[gnu::flatten]] void evaluate_run(const Motion<Scalar<P>, D>& block, const CellRun<D>& run,
                                   UpperCorners<P, D>& of_runs, StressPointExtremes<P>& extremes) {
  using T = Scalar<P>;
  constexpr int corners = 1 << D;
  T volume = 1;
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) volume *= block.spacing;
  // Corners have signs of both kinds in equal number, so a difference over h is 2/2^D of a gradient
  // mode.
  const P slope(T(2) / (corners * block.spacing)), zero(T(0));
  const HourglassWeights<P, D> weights(block.hourglass, block.spacing);
  UpperCorners<P, D> upper = of_runs;
  if (!run.continues) upper.clear();
  const bool starts_before = run.follows && !run.continues;
  for (std::int64_t along = starts_before ? -lanes<P> : 0; along < run.count; along += lanes<P>) {
    const std::int64_t slot = run.first + along;
    if (run.own && along % slots_per_pack == 0) prefetch_pack(block, run, slot);
    const P fraction = load<P>(block.fraction + slot);
    const auto inside = fraction > zero;
    if (!xsimd::any(inside)) {
      if (upper.exist) finish_row<P, D>(block, run, along, upper);
      continue;
    }
    const CutPack<T, D>* const parts =
        cut ? &block.cut_packs[block.cut[slot / slots_per_pack]] : nullptr;
    const auto moment = [parts, lane = slot % slots_per_pack](int m) {
      return load<P>(parts->moment[m] + lane);
    };
    P mode[D][corners];
    displacement_modes<P, D>(block, run, slot, mode);
    if constexpr (cut) {
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) to_means<P, D>(moment, mode[i]);
    }
    CellState<P, D> state;
    regular_state<P, D>(weights, slope, inside, mode, state);
    const RegularSlots<P> slots = {slot, inside, run.own && along >= 0};
    const P pressure = relax_pressures<P>(block.bulk, state.volume_ratio - P(T(1)), slots);
    CellStress<P, D> stress = cell_stress<law, P, D>(block.material, state, pressure);
    P networks(T(0));
    if constexpr (relaxes) {
      networks = relax_networks<P, D>(block.networks, block.material.polynomial, block.examine,
                                      state, slots, stress.piola);
    }
    if (block.initial_stress[0] != nullptr) {
      add_initial_stress<P, D>(block.initial_stress, slot, state.f, stress.piola);
    }
    const P filled = P(volume) * fraction, stiffness = filled * stress.shear;
    const P area = filled * slope;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i) {
      P pull[corners];
#pragma GCC unroll 8
      for (int m = 1; m < corners; ++m) {
        if (directions_of[m] < 2) continue;
        pull[m] = stiffness * mode[i][m];
      }
#pragma GCC unroll 3
      for (int j = 0; j < D; ++j) pull[1 << j] = area * stress.piola[D * i + j];
      if constexpr (cut) from_means<P, D>(moment, pull);
      to_corners<P, D>(pull);
      subtract_forces<P, D>(run, along, pull, upper.force[i], block.force[i]);
    }
    upper.exist = true;
    if (!block.examine) continue;
    const P c2 =
        lattice_wave_speed2<law, P, D>(block.material, state, stress, networks, state.cof, P(T(1)));
    const auto broken = examine<P, D>(state, stress, c2, inside, extremes);
    if (extremes.non_finite < 0 && xsimd::any(broken)) {
      extremes.non_finite = slot + first_lane<P>(broken);
    }
  }
  of_runs = upper;
}

}  // namespace pliant::kernels
