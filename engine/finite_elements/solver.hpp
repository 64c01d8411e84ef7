#pragma once

#include "engine/finite_elements/measure.hpp"
#include "engine/finite_elements/step.hpp"
#include "engine/point_based/observe/field_views.hpp"
#include "engine/point_based/observe/frame.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/undeformed/solver.hpp"

namespace pliant::finite_elements {

/// Advances a case by total Lagrangian explicit dynamics.
template <class T, int D>
class Solver final : public undeformed::Solver<State<T, D>, Step<T, D>, Measurer<T, D>> {
 public:
  /// Throws InputError for bodies whose mesh cannot be read.
  Solver(const Case& settings, const SolverOptions& options);

  std::size_t bytes() const override;

 private:
  using Base = undeformed::Solver<State<T, D>, Step<T, D>, Measurer<T, D>>;

  /// (FE.6)
  double automatic_step() const override;
  Measurer<T, D> measurer() override { return Measurer<T, D>(this->state()); }
  bool has_adaptive_damping() const override {
    return !point_based::parameters_of(this->settings()).damping;
  }
  void show() override { this->state().age_memory(point_based::is_leapfrog(this->settings())); }
  bool velocities_lag() const override { return !point_based::is_leapfrog(this->settings()); }
  bool knows_energy() const override { return point_based::knows_losses(this->settings()); }
  StepFailure failure(const undeformed::StepResult& result) const override;

  double highest_frequency_ = 0;  ///< of all bodies [1/s]
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::finite_elements
