#pragma once

#include <algorithm>

#include "kernels/total_lagrangian/cell_forces.hpp"

/// Stress points of fitted cells, (TL.11), which are few and scattered over the block, and so
/// gathered into registers.
namespace pliant::kernels {

/// A register of fitted cells, starting at `first`; lanes after the last cell repeat it.
template <class P, int D>
struct CellGroup {
  using T = Scalar<P>;
  const FittedCell<T, D>* cell[lanes<P>];
  int count;

  CellGroup(const Motion<T, D>& block, int first)
      : count(block.fitted_count - first < lanes<P> ? block.fitted_count - first : lanes<P>) {
    for (int l = 0; l < lanes<P>; ++l) {
      cell[l] = block.fitted + block.fitted_numbers[first + (l < count ? l : count - 1)];
    }
  }

  /// Value f(cell) for each lane.
  template <class F>
  P of_each(F&& f) const {
    alignas(64) T value[lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) value[l] = f(*cell[l]);
    return P::load_aligned(value);
  }
  P gather(const T* from) const {
    return of_each([from](const FittedCell<T, D>& c) { return from[c.slot]; });
  }
  /// Writes the lanes whose cells belong to the block.
  void scatter(const Motion<T, D>& block, const P& pack, T* to) const {
    alignas(64) T value[lanes<P>];
    pack.store_aligned(value);
    for (int l = 0; l < count; ++l) {
      if (block.has(cell[l]->slot)) to[cell[l]->slot] = value[l];
    }
  }
  /// Subtracts a value at each corner in the block, cell by cell, so that the sums do not depend on
  /// the size of registers.
  void subtract_at_corners(const Motion<T, D>& block, const P (&pull)[1 << D], T* from) const {
    alignas(64) T value[1 << D][lanes<P>];
    for (int c = 0; c < (1 << D); ++c) pull[c].store_aligned(value[c]);
    for (int l = 0; l < count; ++l) {
      for (int c = 0; c < (1 << D); ++c) {
        const std::int64_t corner = cell[l]->slot + cell[l]->row[c >> 1] + (c & 1);
        if (block.has(corner)) from[corner - block.first_slot] -= value[c][l];
      }
    }
  }
};

template <class P, int D>
inline void gather_modes(const Motion<Scalar<P>, D>& block, const CellGroup<P, D>& group,
                         P (&mode)[D][1 << D]) {
  for (int i = 0; i < D; ++i) {
    const Scalar<P>* d = block.displacement[i];
    for (int c = 0; c < (1 << D); ++c) {
      mode[i][c] = group.of_each([d, c](const FittedCell<Scalar<P>, D>& cell) {
        return d[cell.slot + cell.row[c >> 1] + (c & 1)];
      });
    }
    to_modes<P, D>(mode[i]);
  }
}

/// F and the rest of the hourglass modes, zero for linear fields. Replaces the modes by half the
/// derivatives of Q, (TL.6).
template <class P, int D>
inline void fitted_state(const CellGroup<P, D>& group, const HourglassWeights<P, D>& weights,
                         const P& slope, const P (&inverse)[D * D], P (&mode)[D][1 << D],
                         P (&start)[D][1 << D], CellState<P, D>& state) {
  using T = Scalar<P>;
  P gradient[D * D];
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      P sum(T(0));
      for (int a = 0; a < D; ++a) sum = fused(mode[i][1 << a], inverse[D * a + j], sum);
      gradient[D * i + j] = slope * sum;
      state.f[D * i + j] = i == j ? gradient[D * i + j] + P(T(1)) : gradient[D * i + j];
    }
  }
  for (int m = 1; m < (1 << D); ++m) {
    if (directions_of[m] < 2) continue;
    for (int j = 0; j < D; ++j) {
      start[j][m] =
          group.of_each([j, m](const FittedCell<T, D>& cell) { return cell.start[j][m]; });
    }
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        mode[i][m] = fused_minus(gradient[D * i + j], start[j][m], mode[i][m]);
      }
    }
  }
  std::copy_n(state.f, D * D, state.by_f);
  state.hourglass = hourglass_squares<P, D>(weights, state.f, mode, state.by_f);
  state.complete();
}

/// Adds the initial stress (TL.14).
template <class P, int D>
inline void add_fitted_prestress(const Motion<Scalar<P>, D>& block, const CellGroup<P, D>& group,
                                 const CellState<P, D>& state, CellStress<P, D>& stress) {
  if (block.initial_stress[0] == nullptr) return;
  P s[symmetric_components<D>];
  for (int c = 0; c < symmetric_components<D>; ++c) s[c] = group.gather(block.initial_stress[c]);
  add_pulled_back<P, D>(state.f, s, stress.piola);
}

/// The slots of the cells of a group; values are written for cells that belong to the block.
template <class P, int D>
struct FittedSlots {
  using T = Scalar<P>;
  const Motion<T, D>& block;
  const CellGroup<P, D>& group;

  P get(const T* from) const { return group.gather(from); }
  void put(T* to, const P& value, const P&) const { group.scatter(block, value, to); }
};

/// Forces (TL.5) and (TL.6) with the corrections of (TL.11), from half the derivatives of Q with
/// respect to the rest of the hourglass modes.
template <class P, int D>
inline void add_fitted_forces(const Motion<Scalar<P>, D>& block, const CellGroup<P, D>& group,
                              const P& slope, const P (&inverse)[D * D], const P (&mode)[D][1 << D],
                              const P (&start)[D][1 << D], const CellStress<P, D>& stress) {
  using T = Scalar<P>;
  constexpr int corners = 1 << D;
  T cell_volume = 1;
  for (int a = 0; a < D; ++a) cell_volume *= block.spacing;
  const P volume =
      P(cell_volume) * group.of_each([](const FittedCell<T, D>& cell) { return cell.volume; });
  for (int i = 0; i < D; ++i) {
    P pull[corners], effective[D];  // P minus the part of the hourglass forces that depends on F
    for (int j = 0; j < D; ++j) effective[j] = stress.piola[D * i + j];
    for (int m = 1; m < corners; ++m) {
      if (directions_of[m] < 2) continue;
      const P force = stress.shear * mode[i][m];
      for (int j = 0; j < D; ++j) effective[j] = fused_minus(force, start[j][m], effective[j]);
      pull[m] = volume * force;
    }
    for (int a = 0; a < D; ++a) {
      P sum = effective[0] * inverse[D * a];
      for (int j = 1; j < D; ++j) sum = fused(effective[j], inverse[D * a + j], sum);
      pull[1 << a] = volume * slope * sum;
    }
    to_corners<P, D>(pull);
    group.subtract_at_corners(block, pull, block.force[i]);
  }
}

/// Subtracts the forces of the fitted cells from `block.force`.
template <ElasticLaw law, bool relaxes, class P, int D>
void evaluate_fitted_cells(const Motion<Scalar<P>, D>& block, StressPointExtremes<P>& extremes) {
  using T = Scalar<P>;
  constexpr int corners = 1 << D;
  const P slope(T(2) / (corners * block.spacing));
  const HourglassWeights<P, D> weights(block.hourglass, block.spacing);
  for (int first = 0; first < block.fitted_count; first += lanes<P>) {
    const CellGroup<P, D> group(block, first);
    P mode[D][corners], start[D][corners], inverse[D * D];
    for (int c = 0; c < D * D; ++c) {
      inverse[c] = group.of_each([c](const FittedCell<T, D>& cell) { return cell.inverse[c]; });
    }
    gather_modes<P, D>(block, group, mode);
    CellState<P, D> state;
    fitted_state<P, D>(group, weights, slope, inverse, mode, start, state);
    const FittedSlots<P, D> slots = {block, group};
    const P pressure = relax_pressures<P, D>(block.viscosity, state, slots);
    CellStress<P, D> stress = cell_stress<law, P, D>(block.material, state, pressure);
    P networks(T(0));
    if constexpr (relaxes) networks = relax_networks<P, D>(block, state, slots, stress);
    add_fitted_prestress<P, D>(block, group, state, stress);
    add_fitted_forces<P, D>(block, group, slope, inverse, mode, start, stress);
    if (!block.examine) continue;
    P reverse[D * D];
    for (int a = 0; a < D; ++a) {
      for (int i = 0; i < D; ++i) {
        P sum(T(0));
        for (int j = 0; j < D; ++j) sum = fused(inverse[D * a + j], state.cof[D * i + j], sum);
        reverse[D * a + i] = sum;
      }
    }
    const P c2 = lattice_wave_speed2<law, P, D>(block.material, state, stress, networks, reverse,
                                                norm2_bound<P, D>(inverse));
    const auto broken = examine<P, D>(state, stress, c2, slope == slope, extremes);
    if (extremes.non_finite < 0 && xsimd::any(broken)) {
      extremes.non_finite = group.cell[first_lane<P>(broken)]->slot;
    }
  }
}

}  // namespace pliant::kernels
