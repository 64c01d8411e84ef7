#pragma once

#include <string>
#include <vector>

#include "engine/point_based/forces/node_loads.hpp"
#include "engine/point_based/state.hpp"
#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/body_memory.hpp"
#include "engine/undeformed/boundary_work.hpp"
#include "engine/undeformed/contact/body_contact.hpp"
#include "engine/undeformed/contact/wall_contact.hpp"
#include "engine/undeformed/motion_sampler.hpp"
#include "kernels/point_based/table.hpp"
#include "scheduler/phase.hpp"

namespace pliant::point_based {

using undeformed::Advance;

struct StepResult : undeformed::StepResult {
  double frequency2 = 0;  ///< largest lambda q^2 of (PB.12) [1/s^2]; 0 unless computed
};

/// The phases of one time step, in the order of the method's equations.
template <class T, int D>
class Step {
 public:
  Step(State<T, D>& state, const Case& settings, const kernels::PointBasedTable<T, D>& kernels);

  std::vector<scheduler::Phase> phases();

  /// Makes room for the present blocks; phases() calls it too.
  void prepare_blocks();

  static std::vector<std::string> resources() { return resource_numbers.names(); }

  /// Sets the length of the next step and the loads at the time of its kick; moves the blades.
  void prepare(const Advance& advance);

  /// Sums the results of all blocks in their order; adds impulses and work to the state.
  StepResult fold();

  // The functions of the phases, for one block.
  void drift(int block);
  void load(int block) { loads_.load(block); }
  void move(int block);
  /// Called when velocities are final.
  void end_motion(int block);

  /// The relaxing pressures of the body of a block.
  kernels::BulkRelaxation<T> bulk_relaxation(int block) const {
    return memory_[state_.blocks[block].body].bulk.relaxation();
  }

  bool loads_act() const { return loads_.act_on_blocks(); }
  /// Whether velocities change after `move`.
  bool bodies_touch() const {
    return contact_.is_expected() || body_contact_.exists() || has_faces() || has_punctures();
  }
  /// Adds the phases of contact with walls and other bodies.
  void add_contact(PhaseRows& rows, const undeformed::ContactFields& fields);

 private:
  void cut(int block);
  void evaluate_forces(int block);
  bool has_faces() const;
  void push_faces_apart();
  bool has_punctures() const;
  void press_surfaces();
  void meet_walls();
  void meet_attached_walls();
  void add_work_after_contact(int block);
  undeformed::Kick<T> kick() const { return {state_.clock, advance_.length}; }
  /// Power of loads and gravity on a block at the present velocities [W].
  EnergyBudget power(int block) const;

  struct Owned {
    Body<T, D>& body;
    int local;
  };
  Owned owner(int block) const {
    const BlockOwner& owner = state_.blocks[block];
    return {state_.bodies[owner.body], owner.block};
  }
  /// How long nodes move at the velocities after a kick [s].
  double drift_length() const;

  /// Two threads that write to one cache line wait for each other.
  struct alignas(64) BlockResult {
    kernels::PointForcesResult forces;
    kernels::PointMotionSums motion;  ///< with damping, or in a followed body
  };

  State<T, D>& state_;
  const Case& settings_;
  const kernels::PointBasedTable<T, D>& kernels_;
  Advance advance_ = {};
  bool cuts_have_moved_ = false;  ///< in the present step
  NodeLoads<T, D> loads_;
  undeformed::BoundaryWork<T, D> work_;
  undeformed::WallContact<T, D> contact_;
  undeformed::BodyContact<T, D> body_contact_;
  std::vector<BlockResult> results_;  ///< [block]
  undeformed::MotionSampler<T, D> sampler_;
  std::vector<undeformed::BodyMemory<T>> memory_;  ///< [body]
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::point_based
