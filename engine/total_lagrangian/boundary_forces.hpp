#pragma once

#include <optional>
#include <vector>

#include "engine/boundaries/boundary_values.hpp"
#include "engine/method/gravity.hpp"
#include "engine/total_lagrangian/state.hpp"
#include "engine/undeformed/boundary_work.hpp"

namespace pliant::total_lagrangian {

/// What walls, loads and gravity do to the particles in a step, with their impulses and their work
/// (RP.72).
template <class T, int D>
class BoundaryForces {
 public:
  BoundaryForces(State<T, D>& state, const Case& settings);

  /// Whether loads or gravity push particles.
  bool act_on_particles() const { return gravity_.acts() || !state_.boundaries.pressures.empty(); }

  /// Makes room for the results of the present blocks.
  void prepare_blocks();
  /// Fixes when the next step begins, for how long forces act and for how long particles move [s].
  void prepare(double time, double kick, double length);

  /// (TL.7): the force on each patch of a block.
  void sum_patch_loads(int block);
  /// The force on the particles of a block from its patches and by gravity.
  void distribute(int block);
  /// Before the particles of a block move.
  void begin_motion(int block);
  /// After that: constrained particles follow their walls.
  void hold(int block);
  /// When nothing changes velocities any more: the work of loads and gravity.
  void end_motion(int block);

  /// Adds impulses and work of the step to the state, in the order of the blocks; `inertia` is the
  /// sum of m u^2 before the step, `damped` that of the mean velocities in it [J], unless contact
  /// changes these.
  void fold(double inertia, std::optional<double> damped) { work_.fold(inertia, damped); }

 private:
  struct Owned {
    Body<T, D>& body;
    int local;
  };
  Owned owner(int block) {
    const BlockOwner& owner = state_.blocks[block];
    return {state_.bodies[owner.body], owner.block};
  }
  void find_tractions(Body<T, D>& body);
  Point<D> force_on(const Body<T, D>& body, std::size_t patch) const;
  void set_gravity(int block);
  EnergyBudget power_of(int block);

  State<T, D>& state_;
  Gravity<D> gravity_;
  BoundaryValues<D> at_start_;  ///< of the step
  double time_ = 0;
  undeformed::BoundaryWork<T, D> work_;
};

extern template class BoundaryForces<double, 2>;
extern template class BoundaryForces<double, 3>;
extern template class BoundaryForces<float, 2>;
extern template class BoundaryForces<float, 3>;

}  // namespace pliant::total_lagrangian
