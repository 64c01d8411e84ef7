#pragma once

#include "kernels/ghost_state.hpp"
#include "kernels/pack.hpp"
#include "kernels/table.hpp"

/// Ghosts of the free surface, one in each lane: see FreeSurfaceGhosts.
namespace pliant::kernels {

template <class T, class Arch>
struct InverseRoot<xsimd::batch<T, Arch>> {
  using P = xsimd::batch<T, Arch>;
  static P of(const P& square) {
    return xsimd::select(square > P(T(1e-12)), P(T(1)) / xsimd::sqrt(square), P(T(0)));
  }
};

/// Sums of a register of ghosts, field by field.
template <class P, int D>
struct SumColumns {
  static constexpr int width = record_width<D>;
  alignas(64) Scalar<P> lane[3][record_fields<D>][lanes<P>];
  P linear[record_fields<D>], constrained[record_fields<D>], surface[record_fields<D>];

  void take(const Scalar<P>* sums, int l) {
    for (int f = 0; f < record_fields<D>; ++f) lane[0][f][l] = sums[f];
    // Of the fits that are constrained or at the foot point, tractions alone are wanted.
    for (int f = D; f < D + symmetric_components<D>; ++f) {
      lane[1][f][l] = sums[width + f];
      lane[2][f][l] = sums[2 * width + f];
    }
  }

  void load() {
    for (int f = 0; f < record_fields<D>; ++f) linear[f] = P::load_aligned(lane[0][f]);
    for (int f = D; f < D + symmetric_components<D>; ++f) {
      constrained[f] = P::load_aligned(lane[1][f]);
      surface[f] = P::load_aligned(lane[2][f]);
    }
  }
};

/// The ghosts first..first+lanes-1, or as many as there are.
template <class P, int D>
void fill_free_surfaces_from(const FreeSurfaceGhosts<Scalar<P>, D>& ghosts, std::int64_t first,
                             const Impedance<P>& impedance) {
  using T = Scalar<P>;
  constexpr int components = symmetric_components<D>;
  SumColumns<P, D> columns;
  alignas(64) T of_constrained[lanes<P>], of_surface[lanes<P>], pressure[lanes<P>];
  for (int l = 0; l < lanes<P>; ++l) {
    const std::int64_t g = first + l < ghosts.count ? first + l : first;
    columns.take(ghosts.sums + g * 3 * record_width<D>, l);
    of_constrained[l] = ghosts.constrained_sum[g];
    of_surface[l] = ghosts.surface_sum[g];
    pressure[l] =
        ghosts.pressure[g] < 0 ? T(0) : static_cast<T>(ghosts.pressures[ghosts.pressure[g]]);
  }
  columns.load();
  const GhostState<P, D> ghost = free_surface_ghost<P, D>({{columns.linear},
                                                           {columns.constrained},
                                                           {columns.surface},
                                                           P::load_aligned(of_constrained),
                                                           P::load_aligned(of_surface)},
                                                          P::load_aligned(pressure), impedance);
  alignas(64) T velocity[D][lanes<P>], stress[components][lanes<P>];
#pragma GCC unroll 3
  for (int a = 0; a < D; ++a) ghost.velocity[a].store_aligned(velocity[a]);
#pragma GCC unroll 6
  for (int c = 0; c < components; ++c) ghost.stress[c].store_aligned(stress[c]);
  for (int l = 0; l < lanes<P> && first + l < ghosts.count; ++l) {
    if (ghosts.active[first + l] == 0 || ghosts.wall[first + l] >= 0) continue;
    const std::int64_t slot = ghosts.slot[first + l];
    for (int a = 0; a < D; ++a) ghosts.velocity[a][slot] = velocity[a][l];
    for (int c = 0; c < components; ++c) ghosts.stress[c][slot] = stress[c][l];
  }
}

/// See FreeSurfaceGhosts.
template <class P, int D>
void fill_free_surfaces(const FreeSurfaceGhosts<Scalar<P>, D>& ghosts) {
  const Impedance<P> impedance(P(ghosts.pressure_impedance), P(ghosts.shear_impedance));
  for (std::int64_t first = 0; first < ghosts.count; first += lanes<P>) {
    fill_free_surfaces_from<P, D>(ghosts, first, impedance);
  }
}

}  // namespace pliant::kernels
