#pragma once

#include <string>
#include <vector>

#include "engine/total_lagrangian/boundary_forces.hpp"
#include "engine/total_lagrangian/state.hpp"
#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/body_memory.hpp"
#include "engine/undeformed/contact/body_contact.hpp"
#include "engine/undeformed/contact/wall_contact.hpp"
#include "engine/undeformed/motion_sampler.hpp"
#include "kernels/total_lagrangian/table.hpp"
#include "scheduler/phase.hpp"
#include "scheduler/workers.hpp"

namespace pliant::total_lagrangian {

using undeformed::Advance;

/// Results of a step about the state at its end.
struct StepResult : undeformed::StepResult {
  double wave_speed = 0;  ///< of (TL.9) [m/s]; 0 unless the step computed it
};

/// The phases of one time step: the method in the order of its equations.
template <class T, int D>
class Step {
 public:
  Step(State<T, D>& state, const Case& settings, const kernels::TotalLagrangianTable<T, D>& kernels,
       scheduler::Workers& workers);

  std::vector<scheduler::Phase> phases();

  static std::vector<std::string> resources() { return resource_numbers.names(); }

  /// Sets the length of the next step and its damping, and the loads at its time.
  void prepare(const Advance& advance);

  /// Sums the results of all blocks in their order; adds impulses and work to the state.
  StepResult fold();

 private:
  bool bodies_touch() const { return contact_.is_expected() || body_contact_.exists(); }
  void meet_walls();
  void meet_attached_walls();
  void set_cells(const Body<T, D>& body, int local, kernels::Motion<T, D>& work) const;
  void set_particles(Body<T, D>& body, kernels::Motion<T, D>& work) const;
  void reserve_forces();
  void move(int block);
  /// Called when velocities are final.
  void end_motion(int block);
  undeformed::Kick<T> kick() const { return {state_.clock, advance_.kick()}; }

  struct Owned {
    Body<T, D>& body;
    int local;
  };
  Owned owner(int block) {
    const BlockOwner& owner = state_.blocks[block];
    return {state_.bodies[owner.body], owner.block};
  }

  State<T, D>& state_;
  const Case& settings_;
  const kernels::TotalLagrangianTable<T, D>& kernels_;
  Advance advance_ = {};
  BoundaryForces<T, D> boundary_forces_;
  undeformed::WallContact<T, D> contact_;
  undeformed::BodyContact<T, D> body_contact_;
  scheduler::Workers& workers_;
  std::vector<undeformed::BodyMemory<T>> memory_;  ///< [body]
  std::vector<std::array<Buffer<T>, D>> force_;    ///< [worker], for one block at a time [N]
  std::vector<kernels::MotionResult> results_;     ///< [block]
  undeformed::MotionSampler<T, D> sampler_;
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::total_lagrangian
