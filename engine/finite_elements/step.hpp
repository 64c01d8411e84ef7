#pragma once

#include <string>
#include <vector>

#include "engine/finite_elements/fields.hpp"
#include "engine/finite_elements/state.hpp"
#include "engine/point_based/step.hpp"
#include "kernels/finite_elements/table.hpp"

namespace pliant::finite_elements {

/// The phases of one time step: total Lagrangian explicit dynamics in the order of its equations.
template <class T, int D>
class Step {
 public:
  Step(State<T, D>& state, const Case& settings, kernels::Isa isa);

  std::vector<scheduler::Phase> phases();

  static std::vector<std::string> resources() { return resource_numbers.names(); }

  /// Sets the length of the next step and the loads at the time of its kick.
  void prepare(const undeformed::Advance& advance);

  /// Sums the results of all blocks in their order; adds impulses and work to the state.
  undeformed::StepResult fold();

 private:
  kernels::ElementBlock<T, D> elements_of(int block);
  void evaluate_pressures(int block);
  void evaluate_forces(int block);

  State<T, D>& state_;
  const Case& settings_;
  const kernels::FiniteElementsTable<T, D>& kernels_;
  point_based::Step<T, D> nodes_;
  bool examine_ = false;
  std::vector<kernels::PointForcesResult> results_;  ///< [block]
};

extern template class Step<double, 2>;
extern template class Step<double, 3>;
extern template class Step<float, 2>;
extern template class Step<float, 3>;

}  // namespace pliant::finite_elements
