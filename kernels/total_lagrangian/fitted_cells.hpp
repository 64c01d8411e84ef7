#pragma once

#include "kernels/total_lagrangian/cell_forces.hpp"

/// Stress points of fitted cells, (TL.11): few, anywhere in the block, gathered into registers.
namespace pliant::kernels {

/// The fitted cells from `first` on that fill a register; lanes beyond the last repeat it.
template <class P, int D>
struct CellGroup {
  using T = Scalar<P>;
  const FittedCell<T, D>* cell[lanes<P>];
  int count;

  CellGroup(const StressPoints<T, D>& block, int first)
      : count(block.fitted_count - first < lanes<P> ? block.fitted_count - first : lanes<P>) {
    for (int l = 0; l < lanes<P>; ++l) {
      cell[l] = block.fitted + first + (l < count ? l : count - 1);
    }
  }

  /// f(cell) of every lane.
  template <class F>
  P of_each(F&& f) const {
    alignas(64) T value[lanes<P>];
    for (int l = 0; l < lanes<P>; ++l) value[l] = f(*cell[l]);
    return P::load_aligned(value);
  }
  P gather(const T* from) const {
    return of_each([from](const FittedCell<T, D>& c) { return from[c.slot]; });
  }
  void scatter(const P& pack, T* to) const {
    alignas(64) T value[lanes<P>];
    pack.store_aligned(value);
    for (int l = 0; l < count; ++l) to[cell[l]->slot] = value[l];
  }
};

/// Corner rows of a slot; fitted cells are few, so that looking for their segment costs nothing.
template <class Arch, class T, int D>
inline const Segment<D>& segment_of(const StressPoints<T, D>& block, std::int64_t slot) {
  const Segment<D>* segment = block.segments;
  while (slot < segment->first || slot >= segment->first + segment->count) ++segment;
  return *segment;
}

template <class P, int D>
inline void gather_modes(const StressPoints<Scalar<P>, D>& block, const CellGroup<P, D>& group,
                         P (&mode)[D][1 << D]) {
  using T = Scalar<P>;
  alignas(64) T value[D][1 << D][lanes<P>];
  for (int l = 0; l < lanes<P>; ++l) {
    const std::int64_t slot = group.cell[l]->slot;
    const Segment<D>& segment = segment_of<typename P::arch_type>(block, slot);
    for (int c = 0; c < (1 << D); ++c) {
      const std::int64_t corner =
          slot + corner_row<typename P::arch_type>(segment, c >> 1, 1) + (c & 1);
      for (int i = 0; i < D; ++i) value[i][c][l] = block.displacement[i][corner];
    }
  }
  for (int i = 0; i < D; ++i) {
    for (int c = 0; c < (1 << D); ++c) mode[i][c] = P::load_aligned(value[i][c]);
    to_modes<P, D>(mode[i]);
  }
}

/// F and what is left of the hourglass modes, so that linear fields have none.
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
  state.hourglass = hourglass_squares<P, D>(weights, mode);
  state.complete();
}

/// (RP.22) for the cells of a group.
template <class P, int D>
inline P relax_fitted(const StressPoints<Scalar<P>, D>& block, const CellGroup<P, D>& group,
                      const CellState<P, D>& state) {
  using T = Scalar<P>;
  const CellViscosity<T>& viscosity = block.viscosity;
  P sum(T(0));
  if (viscosity.terms == 0) return sum;
  const P start = group.gather(viscosity.volume_change), end = state.volume_ratio - P(T(1));
  for (int i = 0; i < viscosity.terms; ++i) {
    const P before = group.gather(viscosity.pressure[i]);
    const P after = relax_term(viscosity.relaxation[i], before, start, end);
    group.scatter(after, viscosity.pressure[i]);
    sum = sum + after;
  }
  group.scatter(end, viscosity.volume_change);
  return sum;
}

template <class P, int D>
void evaluate_fitted_cells(const StressPoints<Scalar<P>, D>& block,
                           StressPointExtremes<P>& extremes) {
  using T = Scalar<P>;
  constexpr int corners = 1 << D;
  T cell_volume = 1;
  for (int a = 0; a < D; ++a) cell_volume *= block.spacing;
  const P slope(T(2) / (corners * block.spacing));
  const HourglassWeights<P, D> weights(block);
  for (int first = 0; first < block.fitted_count; first += lanes<P>) {
    const CellGroup<P, D> group(block, first);
    P mode[D][corners], start[D][corners], inverse[D * D];
    for (int c = 0; c < D * D; ++c) {
      inverse[c] = group.of_each([c](const FittedCell<T, D>& cell) { return cell.inverse[c]; });
    }
    const P volume =
        P(cell_volume) * group.of_each([](const FittedCell<T, D>& cell) { return cell.volume; });
    gather_modes<P, D>(block, group, mode);
    CellState<P, D> state;
    fitted_state<P, D>(group, weights, slope, inverse, mode, start, state);
    const P pressure = relax_fitted<P, D>(block, group, state);
    const CellStress<P, D> stress = cell_stress<P, D>(block.material, state, pressure);
    for (int i = 0; i < D; ++i) {
      P effective[D];  // P less the part of the hourglass forces that follows F
      for (int j = 0; j < D; ++j) effective[j] = stress.piola[D * i + j];
      for (int m = 1; m < corners; ++m) {
        if (directions_of[m] < 2) continue;
        const P force = stress.shear * P(weights.of[directions_of[m]]) * mode[i][m];
        for (int j = 0; j < D; ++j) {
          effective[j] = fused_minus(force, start[j][m], effective[j]);
        }
        group.scatter(volume * force, block.force[i][m - 1]);
      }
      for (int a = 0; a < D; ++a) {
        P sum = effective[0] * inverse[D * a];
        for (int j = 1; j < D; ++j) sum = fused(effective[j], inverse[D * a + j], sum);
        group.scatter(volume * slope * sum, block.force[i][(1 << a) - 1]);
      }
    }
    if (!block.examine) continue;
    P reverse[D * D];
    for (int a = 0; a < D; ++a) {
      for (int i = 0; i < D; ++i) {
        P sum(T(0));
        for (int j = 0; j < D; ++j) sum = fused(inverse[D * a + j], state.cof[D * i + j], sum);
        reverse[D * a + i] = sum;
      }
    }
    const auto broken =
        examine<P, D>(block.material, state, stress, reverse, slope == slope, extremes);
    if (extremes.non_finite < 0 && xsimd::any(broken)) {
      extremes.non_finite = group.cell[first_lane<P>(broken)]->slot;
    }
  }
}

}  // namespace pliant::kernels
