#pragma once

#include <vector>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/contact/body_contact.hpp"
#include "engine/remeshed/contact/contact_momentum_correction.hpp"
#include "engine/remeshed/remeshing/free_motion_correction.hpp"
#include "engine/remeshed/stage_work.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/remeshed/table.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

/// One step of the remeshed Lagrangian particle method as phases: four Runge-Kutta stages, each
/// with ghosts and particles.
template <class T, int D>
class Step {
 public:
  Step(State<T, D>& state, const Case& settings, const kernels::RemeshedTable<T, D>& kernels);

  /// The phases of a step, in the order of the paper, over the present blocks.
  std::vector<scheduler::Phase> phases();
  /// The phases that update the ghosts of stage 0.
  std::vector<scheduler::Phase> ghost_phases();
  /// The phases that compute the stress of a state that no stage has written.
  std::vector<scheduler::Phase> stress_phases();
  ContactMomentumCorrection<T, D>& momentum() { return momentum_; }

  /// Sets the time step [s] and what the boundaries impose at each stage.
  void prepare(double time_step);
  /// The loads and walls around the bodies at the start of the step, for one thread.
  Surroundings<D> surroundings() const { return work_.around(0); }
  /// Sums the results of a step over all blocks.
  void fold() {
    work_.fold();
    state_.energy.friction += contact_.lost_by_friction();
  }
  /// Adds the effect of a step of `time_step` [s] to the budgets of momentum and spin, after it.
  void follow_motion(double time_step) {
    if (motion_.is_needed()) motion_.add_step(work_.body_forces(), time_step);
  }
  const StageResults& results() const { return work_.results(); }

 private:
  /// Binds a function of StageWork to a stage, for a row.
  template <class Function>
  std::function<void(int)> at(int stage, Function function) {
    return [this, stage, function](int block) { (work_.*function)(block, stage); };
  }

  void add_ghosts(std::vector<scheduler::Phase>& phases, int stage, bool all_of_them);
  void add_advance(std::vector<scheduler::Phase>& phases, int stage);
  Accesses read_by_surface(int stage) const;
  Accesses read_by_ghosts(int stage, bool all_of_them) const;
  Accesses written_by_ghosts(int stage) const;
  Accesses read_by_advance(int stage, scheduler::Reach reach) const;

  void add_shear(std::vector<scheduler::Phase>& phases, int stage);
  bool is_periodic() const;
  std::vector<int> blocks_where(bool listed) const;

  State<T, D>& state_;
  const Case& settings_;
  StageWork<T, D> work_;
  BodyContact<T, D> contact_;
  ContactMomentumCorrection<T, D> momentum_;
  FreeMotionCorrection<T, D> motion_;
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::remeshed
