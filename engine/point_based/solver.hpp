#pragma once

#include "engine/method/blades.hpp"
#include "engine/point_based/observe/field_views.hpp"
#include "engine/point_based/observe/frame.hpp"
#include "engine/point_based/observe/measure.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/step.hpp"
#include "engine/undeformed/solver.hpp"

namespace pliant::point_based {

/// Advances a case by the point-based method.
template <class T, int D>
class Solver final : public undeformed::Solver<State<T, D>, Step<T, D>, Measurer<T, D>>,
                     public Blades {
 public:
  /// Throws InputError for bodies that hold no nodes.
  Solver(const Case& settings, const SolverOptions& options);

  void put_blade(std::size_t cut, const std::array<double, 3>& from,
                 const std::array<double, 3>& to) override;
  void lift_blade(std::size_t cut) override;
  std::array<double, 3> blade_force(std::size_t cut) const override;

 private:
  using Base = undeformed::Solver<State<T, D>, Step<T, D>, Measurer<T, D>>;

  /// (PB.12)
  double automatic_step() const override;
  Measurer<T, D> measurer() override { return Measurer<T, D>(this->state()); }
  bool velocities_lag() const override { return !is_leapfrog(this->settings()); }
  bool knows_energy() const override { return knows_losses(this->settings()); }
  StepFailure failure(const StepResult& result) const override;
  bool has_adaptive_damping() const override { return !parameters_of(this->settings()).damping; }
  void adapt(const Advance& advance, const StepResult& result) override;
  void show() override { this->state().age_memory(is_leapfrog(this->settings())); }
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;

  /// Upper bound of the ratio of squared frequencies with initial stress to those without.
  double stiffening_ = 1;
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::point_based
