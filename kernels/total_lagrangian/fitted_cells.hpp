#pragma once

#include <algorithm>

#include "kernels/total_lagrangian/cell_forces.hpp"

/// Stress points of fitted cells, (TL.11), which are few and scattered over the block, so that
/// displacements are gathered into registers.
namespace pliant::kernels {

/// The cells of a pack from a lane on, one in each lane of a register.
template <class P, int D>
struct CellGroup {
  using T = Scalar<P>;
  const FittedPack<T, D>& pack;
  int lane;

  P constant(const T (&of_lanes)[slots_per_pack]) const { return load<P>(of_lanes + lane); }
  /// Values at slots given for each lane.
  P gather(const std::int64_t (&slot)[slots_per_pack], const T* from) const {
    alignas(64) T value[lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) value[l] = from[slot[lane + l]];
    return P::load_aligned(value);
  }
  P gather(const T* from) const { return gather(pack.slot, from); }
  P moment(int mode) const { return constant(pack.moment[mode]); }
  /// Writes the lanes whose cells belong to the block.
  void scatter(const Motion<T, D>& block, const P& value, T* to) const {
    alignas(64) T of_lane[lanes<P>];
    value.store_aligned(of_lane);
    for (int l = 0; l < lanes<P> && lane + l < pack.count; ++l) {
      if (block.has(pack.slot[lane + l])) to[pack.slot[lane + l]] = of_lane[l];
    }
  }
  /// Subtracts a value at each corner in the block, cell by cell, so that the sums do not depend on
  /// the size of registers.
  void subtract_at_corners(const P (&pull)[1 << D], T* from) const {
    alignas(64) T value[1 << D][lanes<P>];
    for (int c = 0; c < (1 << D); ++c) pull[c].store_aligned(value[c]);
    for (int l = 0; l < lanes<P>; ++l) {
      for (int c = 0; c < (1 << D); ++c) {
        const std::int32_t corner = pack.target[c][lane + l];
        if (corner >= 0) from[corner] -= value[c][l];
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
      mode[i][c] = group.gather(group.pack.corner[c], d);
    }
    to_modes<P, D>(mode[i]);
    to_means<P, D>([&](int m) { return group.moment(m); }, mode[i]);
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
    for (int j = 0; j < D; ++j) start[j][m] = group.constant(group.pack.start[j][m]);
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        mode[i][m] = fused_minus(gradient[D * i + j], start[j][m], mode[i][m]);
      }
    }
  }
  std::copy_n(state.f, D * D, state.by_f);
  state.hourglass = hourglass_squares<P, D>(weights, state.f, mode, state.by_f);
  state.find_cofactor();
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
  const P volume = P(cell_volume) * group.constant(group.pack.volume);
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
    from_means<P, D>([&](int m) { return group.moment(m); }, pull);
    to_corners<P, D>(pull);
    group.subtract_at_corners(pull, block.force[i]);
  }
}

/// Subtracts the forces of a group of fitted cells from `block.force`.
template <ElasticLaw law, bool relaxes, class P, int D>
[[gnu::flatten]] void evaluate_fitted_group(const Motion<Scalar<P>, D>& block,
                                            const CellGroup<P, D>& group,
                                            StressPointExtremes<P>& extremes) {
  using T = Scalar<P>;
  constexpr int corners = 1 << D;
  const P slope(T(2) / (corners * block.spacing));
  const HourglassWeights<P, D> weights(block.hourglass, block.spacing);
  P mode[D][corners], start[D][corners], inverse[D * D];
  for (int c = 0; c < D * D; ++c) inverse[c] = group.constant(group.pack.inverse[c]);
  gather_modes<P, D>(block, group, mode);
  CellState<P, D> state;
  fitted_state<P, D>(group, weights, slope, inverse, mode, start, state);
  const FittedSlots<P, D> slots = {block, group};
  const P pressure = relax_pressures<P>(block.bulk, state.volume_ratio - P(T(1)), slots);
  CellStress<P, D> stress = cell_stress<law, P, D>(block.material, state, pressure);
  P networks(T(0));
  if constexpr (relaxes) {
    networks = relax_networks<P, D>(block.networks, block.material.polynomial, block.examine, state,
                                    slots, stress.piola);
  }
  add_fitted_prestress<P, D>(block, group, state, stress);
  add_fitted_forces<P, D>(block, group, slope, inverse, mode, start, stress);
  if (!block.examine) return;
  P reverse[D * D];
  for (int a = 0; a < D; ++a) {
    for (int i = 0; i < D; ++i) {
      P sum(T(0));
      for (int j = 0; j < D; ++j) sum = fused(inverse[D * a + j], state.cof[D * i + j], sum);
      reverse[D * a + i] = sum;
    }
  }
  const P c2 = group.constant(group.pack.moves) *
               lattice_wave_speed2<law, P, D>(block.material, state, stress, networks, reverse,
                                              norm2_bound<P, D>(inverse));
  const auto broken = examine<P, D>(state, stress, c2, slope == slope, extremes);
  if (extremes.non_finite < 0 && xsimd::any(broken)) {
    extremes.non_finite = group.pack.slot[group.lane + first_lane<P>(broken)];
  }
}

/// The same for all fitted cells of the block.
template <ElasticLaw law, bool relaxes, class P, int D>
void evaluate_fitted_cells(const Motion<Scalar<P>, D>& block, StressPointExtremes<P>& extremes) {
  for (int p = 0; p < block.fitted_count; ++p) {
    const FittedPack<Scalar<P>, D>& pack = block.fitted[p];
    for (int lane = 0; lane < pack.count; lane += lanes<P>) {
      evaluate_fitted_group<law, relaxes, P, D>(block, {pack, lane}, extremes);
    }
  }
}

}  // namespace pliant::kernels
