#pragma once

#include <vector>

#include "engine/boundaries/boundary_values.hpp"
#include "engine/method/gravity.hpp"
#include "engine/total_lagrangian/state.hpp"
#include "engine/undeformed/boundary_work.hpp"

namespace pliant::total_lagrangian {

/// A facet as a load finds it.
template <int D>
struct PresentFacet {
  int number = -1;
  BoundaryCase::LoadedArea area_of_load = {};
  std::array<Point<D>, D> corner = {};  ///< [m]
  Point<D> area = {};                   ///< outwards [m^(D-1)]
};

/// Forces of walls, loads and gravity on the particles in a step, with their impulses and their
/// work (RP.72).
template <class T, int D>
class BoundaryForces {
 public:
  BoundaryForces(State<T, D>& state, const Case& settings);

  /// Whether loads or gravity act on particles.
  bool act_on_particles() const { return gravity_.acts() || !state_.boundaries.pressures.empty(); }

  void prepare_blocks();
  /// Sets the time at which the next step begins, the duration of forces and that of motion [s].
  void prepare(double time, double kick, double length);

  /// Sums the force on each patch of a block, (TL.7).
  void sum_patch_loads(int block);
  /// Distributes the forces on its patches to the particles of a block, and adds gravity.
  void distribute(int block);
  /// Called before the particles of a block move.
  void begin_motion(int block);
  /// Called after that: constrained particles follow their walls.
  void hold(int block);
  /// Called with the velocities at the end of the step, for the work of loads and gravity.
  void end_motion(int block);
  /// The same, also once more, if contact has changed velocities since hold().
  void end_motion_after_contact(int block);

  /// Adds impulses and work of a block to the state, as undeformed::BoundaryWork does.
  void fold(int block, double inertia, double damped) { work_.fold(block, inertia, damped); }

 private:
  struct Owned {
    Body<T, D>& body;
    int local;
  };
  Owned owner(int block) {
    const BlockOwner& owner = state_.blocks[block];
    return {state_.bodies[owner.body], owner.block};
  }
  Point<D> force_on(const SurfacePatch<D>& patch, const PresentFacet<D>& facet) const;
  void set_gravity(int block);
  EnergyBudget power_of(int block);

  State<T, D>& state_;
  Gravity<D> gravity_;
  BoundaryValues<D> at_start_;  ///< at the start of the step
  double time_ = 0;
  undeformed::BoundaryWork<T, D> work_;
};

extern template class BoundaryForces<double, 2>;
extern template class BoundaryForces<double, 3>;
extern template class BoundaryForces<float, 2>;
extern template class BoundaryForces<float, 3>;

}  // namespace pliant::total_lagrangian
