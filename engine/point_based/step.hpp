#pragma once

#include <string>
#include <vector>

#include "engine/point_based/forces/node_loads.hpp"
#include "engine/point_based/state.hpp"
#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/body_contact.hpp"
#include "engine/undeformed/boundary_work.hpp"
#include "engine/undeformed/wall_contact.hpp"
#include "kernels/point_based/table.hpp"
#include "scheduler/phase.hpp"

namespace pliant::point_based {

using undeformed::Advance;

struct StepResult : undeformed::StepResult {
  double frequency2 = 0;  ///< largest lambda q^2 of (PB.12) [1/s^2]; 0 unless examined
};

/// The phases of one time step: the method in the order of its equations.
template <class T, int D>
class Step {
 public:
  Step(State<T, D>& state, const Case& settings, const kernels::PointBasedTable<T, D>& kernels);

  std::vector<scheduler::Phase> phases();

  /// Makes room for the present blocks; phases() has done so.
  void prepare_blocks();

  /// Names of what phases read and write.
  static std::vector<std::string> resources() { return resource_numbers.names(); }

  /// Sets how the next step advances, and the loads at the time of its kick; moves the blades on.
  void prepare(const Advance& advance);

  /// Folds the results of all blocks, in their order, impulses and work into the state.
  StepResult fold();

  // What phases do to a block.
  void drift(int block);
  void load(int block) { loads_.load(block); }
  void move(int block);
  /// When nothing changes velocities any more.
  void end_motion(int block);

  bool loads_act() const { return loads_.act_on_blocks(); }
  /// Whether velocities change after the motion.
  bool bodies_touch() const {
    return contact_.exists() || body_contact_.exists() || has_faces() || has_punctures();
  }
  /// Adds what lets contact walls and other bodies push the nodes.
  void add_contact(PhaseRows& rows, const undeformed::ContactFields& fields);

 private:
  void cut(int block);
  void evaluate_forces(int block);
  bool has_faces() const;
  void meet_faces();
  bool has_punctures() const;
  void dent_surfaces();
  /// Of loads and gravity on a block, with the present velocities [W].
  EnergyBudget power(int block) const;

  struct Owned {
    Body<T, D>& body;
    int local;
  };
  Owned owner(int block) const {
    const BlockOwner& owner = state_.blocks[block];
    return {state_.bodies[owner.body], owner.block};
  }
  /// For how long nodes move at the velocities that a kick leaves behind [s].
  double drift_length() const;

  State<T, D>& state_;
  const Case& settings_;
  const kernels::PointBasedTable<T, D>& kernels_;
  Advance advance_ = {};
  bool cuts_have_moved_ = false;  ///< in the present step
  NodeLoads<T, D> loads_;
  undeformed::BoundaryWork<T, D> work_;
  undeformed::WallContact<T, D> contact_;
  undeformed::BodyContact<T, D> body_contact_;
  std::vector<kernels::PointForcesResult> results_;  ///< [block]
  std::vector<double> inertia_;  ///< [block] sum of m u^2 before the step, with damping [J]
  std::vector<double> damped_;   ///< [block] what damping acts on in it [J]
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::point_based
