#pragma once

#include "engine/finite_elements/step.hpp"
#include "engine/undeformed/solver.hpp"

namespace pliant::finite_elements {

/// Advances a case by total Lagrangian explicit dynamics.
template <class T, int D>
class Solver final : public undeformed::Solver<T, D> {
 public:
  /// Throws InputError for bodies whose mesh cannot be read.
  Solver(const Case& settings, const SolverOptions& options);

  /// What is left of a step that an output time divides, else (FE.6).
  double time_step() const override;
  std::size_t bytes() const override;

  BodyIntegrals integrals() override;
  /// Of the leapfrog, whose velocities belong to the time of the displacements.
  std::optional<EnergyBudget> energy_budget() const override;
  Frame frame(const FrameParts& parts) override;

  std::vector<SlotRun> particle_runs(int body) const override;
  std::vector<std::array<double, 3>> positions(int body) const override;

  State<T, D>& state() { return state_; }
  const State<T, D>& state() const { return state_; }

 private:
  using Base = undeformed::Solver<T, D>;

  State<T, D>& shared() override { return state_; }
  const State<T, D>& shared() const override { return state_; }
  int body_count() const override { return static_cast<int>(state_.bodies.size()); }
  point_based::Body<T, D>& body(int number) override { return state_.bodies.at(number); }
  const point_based::Body<T, D>& body(int number) const override {
    return state_.bodies.at(number);
  }
  void begin_step() override;
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  void check(const point_based::StepResult& result) const;

  State<T, D> state_;
  Step<T, D> step_;
  double highest_frequency_ = 0;  ///< of all bodies [1/s]
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::finite_elements
