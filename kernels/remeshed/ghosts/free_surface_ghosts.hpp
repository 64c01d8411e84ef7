#pragma once

#include "kernels/pack.hpp"
#include "kernels/remeshed/ghosts/arguments.hpp"
#include "kernels/remeshed/ghosts/ghost_state.hpp"
#include "kernels/remeshed/ghosts/ghost_sums.hpp"

/// Ghosts of the free surface, one in each lane: see FreeSurfaceGhosts.
namespace pliant::kernels {

template <class T, class Arch>
struct InverseRoot<xsimd::batch<T, Arch>> {
  using P = xsimd::batch<T, Arch>;
  static P of(const P& square) {
    return xsimd::select(square > P(T(1e-12)), P(T(1)) / xsimd::sqrt(square), P(T(0)));
  }
};

/// Sums of a register of ghosts, field by field. Constrained fits and fits at the foot point are
/// only needed for tractions.
template <class P, int D>
struct SumColumns {
  static constexpr int width = record_width<D>, stresses = symmetric_components<D>;
  static_assert(RecordPlace<D>::stress == 0);
  alignas(64) Scalar<P> lane[width + 2 * stresses][lanes<P>] = {};
  P linear[width], constrained[stresses], surface[stresses];

  void take(const Scalar<P>* sums, int l) {
    for (int f = 0; f < width; ++f) lane[f][l] = sums[f];
    for (int f = 0; f < stresses; ++f) {
      lane[width + f][l] = sums[width + f];
      lane[width + stresses + f][l] = sums[2 * width + f];
    }
  }

  void load() {
    for (int f = 0; f < width; ++f) linear[f] = P::load_aligned(lane[f]);
    for (int f = 0; f < stresses; ++f) {
      constrained[f] = P::load_aligned(lane[width + f]);
      surface[f] = P::load_aligned(lane[width + stresses + f]);
    }
  }
};

/// A register of ghosts, one in each lane.
template <class P, int D>
class GhostLanes {
  using T = Scalar<P>;
  static constexpr int components = symmetric_components<D>;

 public:
  explicit GhostLanes(const FreeSurfaceGhosts<T, D>& ghosts)
      : ghosts_(ghosts), impedance_(P(ghosts.pressure_impedance), P(ghosts.shear_impedance)) {}

  bool are_full() const { return count_ == lanes<P>; }

  /// The sums stay in the first cache.
  void add(std::int64_t g) {
    alignas(64) T sums[3 * record_width<D>];
    sum_ghost<P, D, components>(ghosts_.lists, g, sums);
    columns_.take(sums, count_);
    constrained_sum_[count_] = ghosts_.constrained_sum[g];
    surface_sum_[count_] = ghosts_.surface_sum[g];
    const int p = ghosts_.pressure[g];
    pressure_[count_] = p < 0 ? T(0) : static_cast<T>(ghosts_.pressures[p]);
    ghost_[count_] = g;
    slot_[count_++] = ghosts_.slot[g];
  }

  void write() {
    columns_.load();
    const GhostFits<P, D> fits{{columns_.linear},
                               {columns_.constrained},
                               {columns_.surface},
                               P::load_aligned(constrained_sum_),
                               P::load_aligned(surface_sum_)};
    const GhostState<P, D> ghost =
        free_surface_ghost<P, D>(fits, P::load_aligned(pressure_), impedance_);
    alignas(64) T velocity[D][lanes<P>], correction[D][lanes<P>], stress[components][lanes<P>];
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      ghost.velocity[a].store_aligned(velocity[a]);
      (ghost.velocity[a] - fits.linear.velocity(a)).store_aligned(correction[a]);
    }
#pragma GCC unroll 6
    for (int c = 0; c < components; ++c) ghost.stress[c].store_aligned(stress[c]);
    for (int l = 0; l < count_; ++l) {
      for (int a = 0; a < D; ++a) {
        ghosts_.velocity[a][slot_[l]] = velocity[a][l];
        ghosts_.correction[ghost_[l] * D + a] = correction[a][l];
      }
      for (int c = 0; c < components; ++c) ghosts_.stress[c][slot_[l]] = stress[c][l];
    }
    count_ = 0;
  }

 private:
  const FreeSurfaceGhosts<T, D>& ghosts_;
  Impedance<P> impedance_;
  SumColumns<P, D> columns_;
  alignas(64) T constrained_sum_[lanes<P>] = {}, surface_sum_[lanes<P>] = {};
  alignas(64) T pressure_[lanes<P>] = {};
  std::int64_t ghost_[lanes<P>];
  std::int32_t slot_[lanes<P>];
  int count_ = 0;
};

template <class P, int D>
void fill_free_surfaces(const FreeSurfaceGhosts<Scalar<P>, D>& ghosts) {
  GhostLanes<P, D> filling(ghosts);
  for (std::int64_t g = 0; g < ghosts.lists.count; ++g) {
    if (ghosts.active[g] == 0 || ghosts.wall[g] >= 0) continue;
    filling.add(g);
    if (filling.are_full()) filling.write();
  }
  filling.write();
}

}  // namespace pliant::kernels
