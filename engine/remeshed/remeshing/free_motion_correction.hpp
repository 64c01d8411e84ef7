#pragma once

#include <vector>

#include "engine/remeshed/loads/body_forces.hpp"
#include "engine/remeshed/observe/motion_integrals.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

// The momentum and the angular momentum of free bodies, (RP.90), (RP.91).
//
// Steps and remeshings change both by the errors of the method. The sum of div sigma over fitted
// ghosts equals the surface traction only to the accuracy of the method. A remeshing smooths the
// velocity at the surface and moves the surface at edges. Each error is small, but the errors of
// many revolutions of a body accumulate. Yet the momentum of a body that no wall, body or load
// pushes is known: it changes only by body forces. So is its spin, the angular momentum about its
// own mass centre, which does not depend on the path of the centre.
//
// Therefore each body has a budget of both. After each remeshing, when particles are on nodes and
// the integrals (RP.42) over the body are those that are measured, a rigid velocity a + omega x (x
// - c) is added to the body so that its integrals equal the budget. This does not change strain,
// stress or relative motion. A change of the mass by a remeshing is not an impulse: it changes the
// momentum of the budget in proportion, so that the mass centre keeps its velocity. If something
// has pushed the body since the last remeshing, its budget is set to the state after the remeshing.
// Bodies with ghosts of walls or loads after a remeshing have no budget until the next one.
//
// In a case with contact, the momentum has another budget, which includes the impulses of contacts
// and is applied after each step: contact_momentum_correction.hpp. This correction then only
// applies to the spin.
namespace pliant::remeshed {

/// Corrects momentum and spin of free bodies after each remeshing, (RP.90).
template <class T, int D>
class FreeMotionCorrection {
 public:
  /// `weighs_held_bodies`: whether the budgets of bodies with ghosts of walls or loads hold their
  /// masses.
  FreeMotionCorrection(State<T, D>& state, const Case& settings, bool weighs_held_bodies)
      : state_(state),
        weighs_held_bodies_(weighs_held_bodies),
        is_needed_(parameters_of(settings).free_motion == FreeMotion::kept),
        keeps_velocity_(settings.contacts.empty() && !state.boundaries.have_contact()) {}

  bool is_needed() const { return is_needed_; }

  /// Adds the body forces of a step to the budgets, (RP.91), and discards those of bodies that
  /// touch another one in it.
  void add_step(const std::vector<std::array<ForceOnBlock<D>, 4>>& forces, double time_step);
  /// Phases that correct the motion of bodies on nodes to their budgets, (RP.90).
  void add_phases(std::vector<scheduler::Phase>& phases);

 private:
  struct Correction {
    Vector velocity = {}, angular_velocity = {}, centre = {};
    bool acts = false;
  };
  bool is_followed(const Body<T, D>& body) const {
    return body.has_surface && !body.lattice.is_periodic();
  }
  void integrate(int block);
  void balance();
  Correction correction(const MotionIntegrals& now, const MotionBudget<D>& budget) const;
  void correct(int block);

  State<T, D>& state_;
  bool weighs_held_bodies_, is_needed_, keeps_velocity_;
  std::vector<ForceOnBlock<D>> on_body_;  ///< of one stage
  std::vector<MotionIntegrals> of_block_, sums_;
  std::vector<Correction> of_body_;
};

extern template class FreeMotionCorrection<double, 2>;
extern template class FreeMotionCorrection<double, 3>;
extern template class FreeMotionCorrection<float, 2>;
extern template class FreeMotionCorrection<float, 3>;

}  // namespace pliant::remeshed
