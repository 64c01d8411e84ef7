#pragma once

#include <array>
#include <vector>

#include "engine/remeshed/contact/body_contact.hpp"
#include "engine/remeshed/contact/momentum_correction.hpp"
#include "engine/remeshed/ghosts/ghost_fill.hpp"
#include "engine/remeshed/particle_update.hpp"
#include "engine/remeshed/state.hpp"
#include "kernels/remeshed/table.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// One step of the remeshed Lagrangian particle method as phases: four Runge-Kutta stages, each of
/// ghosts and particles.
template <class T, int D>
class Step {
 public:
  Step(State<T, D>& state, const Case& settings, const kernels::RemeshedTable<T, D>& kernels);

  /// The phases of a step, in the order of the paper, over the present blocks.
  std::vector<scheduler::Phase> phases();
  /// Those that bring the ghosts of stage 0 up to date.
  std::vector<scheduler::Phase> ghost_phases();
  /// Those that compute the stress of a state that no stage has left behind.
  std::vector<scheduler::Phase> stress_phases();
  MomentumCorrection<T, D>& momentum() { return momentum_; }

  /// Fixes the time step [s] and what the boundaries impose at each stage.
  void prepare(double time_step);
  /// Folds what a step found over the blocks in their order, the impulse of contact walls into the
  /// state.
  void fold();
  const kernels::StageResult& result() const { return result_; }
  /// The block of the slot that is no longer finite, or -1.
  int failed_block() const { return failed_block_; }
  /// max abs(eps)_F of one body in the last step [1/s].
  double strain_rate(int body) const { return strain_rates_[body]; }

 private:
  using Accesses = std::vector<scheduler::Access>;

  /// A phase that runs on each block, with the body and the number that the block has in it.
  template <class F>
  scheduler::Phase on_blocks(const char* name, int stage, const Accesses& reads,
                             const Accesses& writes, F run);

  bool periodic() const;
  std::vector<int> blocks_where(bool listed) const;
  void add_ghosts(std::vector<scheduler::Phase>& phases, int stage, WhichGhosts which);
  void add_filling(std::vector<scheduler::Phase>& phases, int stage, WhichGhosts which);
  void add_pair_stress(std::vector<scheduler::Phase>& phases, int stage);
  void add_advance(std::vector<scheduler::Phase>& phases, int stage);
  void add_advance(std::vector<scheduler::Phase>& phases, int stage, scheduler::Reach reach,
                   const std::vector<int>& blocks);

  void fill(int block, int stage);
  void fill_all(int block, int stage);

  State<T, D>& state_;
  const Case& settings_;
  const kernels::RemeshedTable<T, D>& kernels_;
  ParticleUpdate<T, D> particles_;
  BodyContact<T, D> contact_;
  MomentumCorrection<T, D> momentum_;
  double time_step_ = 0;
  std::array<BoundaryValues<D>, 4> boundary_values_;  ///< [stage]
  std::vector<kernels::StageResult> results_;         ///< [block]
  kernels::StageResult result_ = {0, 0, -1};
  std::vector<double> strain_rates_;  ///< [body]
  int failed_block_ = -1;
  std::vector<Point<D>> impulse_;  ///< [block][wall] of contact walls on the bodies, of this step
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::remeshed
