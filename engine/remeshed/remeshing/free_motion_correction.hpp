#pragma once

#include <vector>

#include "engine/remeshed/loads/body_forces.hpp"
#include "engine/remeshed/observe/motion_integrals.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

// The momentum and the angular momentum of bodies that nothing holds, (RP.90), (RP.91).
//
// A step and a remeshing change both by the errors of the method: div sigma over fitted ghosts adds
// up to the surface traction only as far as the method is accurate, and a remeshing smooths the
// velocity at the surface and moves the surface where it has edges. Each error is small and has no
// sign of its own, so that they add up over the turns of a body. But the momentum of a body that no
// wall, no other body and no load pushes is known: it changes by body forces alone. So is its spin,
// the angular momentum about its own mass centre, which the path of the centre does not change.
//
// Each body therefore has a budget of both. After each remeshing, when particles lie on nodes and
// the integrals (RP.42) over the body are those that are measured, a rigid velocity
// a + omega x (x - c) is added to the body so that its integrals are those of the budget. It
// changes no strain, no stress and no relative motion. What a remeshing does to the mass is no
// impulse: it changes the momentum of the budget alike, so that the mass centre keeps its velocity.
// What pushed the body since the last
// remeshing makes the budget unknown; it is then what the remeshing has left. Bodies that come out
// of a remeshing with ghosts of walls or loads have none until the next one.
//
// In a case with contact momentum has a budget that knows what contacts transmit, and that is kept
// after each step: contact_momentum_correction.hpp. There this correction is that of the spin
// alone.
namespace pliant::remeshed {

/// Corrects momentum and spin of free bodies after each remeshing, (RP.90).
template <class T, int D>
class FreeMotionCorrection {
 public:
  FreeMotionCorrection(State<T, D>& state, const Case& settings)
      : state_(state),
        is_needed_(parameters_of(settings).free_motion == FreeMotion::kept),
        keeps_velocity_(settings.contacts.empty() && !state.boundaries.have_contact()) {}

  bool is_needed() const { return is_needed_; }

  /// Changes the budgets by the body forces of a step, (RP.91), and forgets those of bodies that
  /// touch another one in it.
  void add_step(const std::vector<std::array<ForceOnBlock<D>, 4>>& forces, double time_step);
  /// Phases that give bodies on nodes the motion of their budgets, (RP.90).
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
  bool is_needed_, keeps_velocity_;
  std::vector<ForceOnBlock<D>> on_body_;  ///< of one stage
  std::vector<MotionIntegrals> of_block_, sums_;
  std::vector<Correction> of_body_;
};

extern template class FreeMotionCorrection<double, 2>;
extern template class FreeMotionCorrection<double, 3>;
extern template class FreeMotionCorrection<float, 2>;
extern template class FreeMotionCorrection<float, 3>;

}  // namespace pliant::remeshed
