#pragma once

#include "engine/total_lagrangian/observe/field_views.hpp"
#include "engine/total_lagrangian/observe/frame.hpp"
#include "engine/total_lagrangian/observe/measure.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "engine/total_lagrangian/step.hpp"
#include "engine/undeformed/solver.hpp"

namespace pliant::total_lagrangian {

/// Advances a case by the total Lagrangian method.
template <class T, int D>
class Solver final : public undeformed::Solver<State<T, D>, Step<T, D>, Measurer<T, D>> {
 public:
  /// Throws std::invalid_argument for a case that the method cannot run.
  Solver(const Case& settings, const SolverOptions& options);

 private:
  using Base = undeformed::Solver<State<T, D>, Step<T, D>, Measurer<T, D>>;

  double automatic_step() const override;
  Measurer<T, D> measurer() override { return Measurer<T, D>(this->state(), this->workers()); }
  bool velocities_lag() const override { return true; }
  StepFailure failure(const StepResult& result) const override;
  bool has_adaptive_damping() const override { return !parameters_of(this->settings()).damping; }
  void adapt(const Advance& advance, const StepResult& result) override;
  void show() override { this->state().age_memory(); }
  double smallest_spacing() const;  ///< of all bodies [m]
  void scale_mass();
  void limit_cfl(const BodyCase& source, const Body<T, D>& body);

  double cfl_;  ///< that of the case, limited by (TL.23)
  double stress_wave_speed_ =
      0;  ///< its square is what initial stresses add to that of the wave speed [m/s]
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::total_lagrangian
