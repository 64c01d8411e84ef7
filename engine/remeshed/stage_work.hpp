#pragma once

#include <array>
#include <vector>

#include "engine/method/energy_budget.hpp"
#include "engine/remeshed/ghosts/ghost_fill.hpp"
#include "engine/remeshed/ghosts/ghost_motion.hpp"
#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/loads/wall_impulses.hpp"
#include "engine/remeshed/particle_update.hpp"
#include "engine/remeshed/state/stage_results.hpp"
#include "engine/remeshed/state/state.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// The work of the phases of a step on one block at one stage, and their results.
template <class T, int D>
class StageWork {
 public:
  StageWork(State<T, D>& state, const Case& settings, const kernels::RemeshedTable<T, D>& kernels)
      : state_(state),
        settings_(settings),
        kernels_(kernels),
        particles_(state, settings, kernels),
        walls_(state, settings) {}

  void prepare_blocks() { results_.reset(state_.blocks, state_.bodies.size()); }
  /// Sets the time step [s] and what the boundaries impose at each stage.
  void prepare(double time_step);

  void copy_image_positions(int block, int stage);
  void copy_image_states(int block, int stage);
  void write_records(int block, int stage);
  void decide_wall_contact(int block, int stage);
  void release_wall_contact(int block, int stage);
  /// The first fills the ghosts that particles read at a stage, while the others only drift.
  void fill_reached_ghosts(int block, int stage);
  void fill_all_ghosts(int block, int stage);
  void evaluate_shear_forces(int block, int stage);
  void take_shear_stresses(int block, int stage);
  void give_back_shear_stresses(int block);
  void advance(int block, int stage);
  void evaluate_stress(int block) { results_[block] = particles_.evaluate_stress(block); }

  /// Sums the results of a step over the blocks in their order; adds impulses and work to the
  /// state.
  void fold();
  /// [block] impulse of body forces in the step [N s].
  const std::vector<Point<D>>& body_force_impulse() const {
    return particles_.body_force_impulse();
  }
  /// [block][wall] impulse of walls on the bodies in the step [N s].
  const std::vector<Point<D>>& wall_impulse() const { return walls_.of_blocks(); }
  /// [block] whether it stuck to a contact wall at any time in the step.
  const std::vector<char>& sticks() const { return sticks_; }
  /// [block][stage] body forces in the step.
  const std::vector<std::array<ForceOnBlock<D>, 4>>& body_forces() const {
    return particles_.body_forces();
  }
  /// Whether forces of walls depend on the masses of the bodies that they hold, (RP.105).
  bool weighs_held_bodies() const { return walls_.weigh_held_bodies(); }
  const StageResults& results() const { return results_; }
  Surroundings<D> around(int stage) const {
    return {state_.boundaries, boundary_values_[stage], particles_.body_force(stage)};
  }

 private:
  void fill(int block, int stage, WhichGhosts which, WallWork<T, D>* work);

  State<T, D>& state_;
  const Case& settings_;
  const kernels::RemeshedTable<T, D>& kernels_;
  ParticleUpdate<T, D> particles_;
  WallImpulses<T, D> walls_;
  double time_step_ = 0;
  std::array<BoundaryValues<D>, 4> boundary_values_;  ///< [stage]
  StageResults results_;
  std::vector<EnergyBudget> work_;  ///< [block] work of walls and loads in this step
  std::vector<char> sticks_;        ///< [block] whether it stuck to contact walls in this step
};

extern template class StageWork<double, 2>;
extern template class StageWork<double, 3>;
extern template class StageWork<float, 2>;
extern template class StageWork<float, 3>;

}  // namespace pliant::remeshed
