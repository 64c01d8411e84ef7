#pragma once

#include "engine/total_lagrangian/step.hpp"
#include "engine/undeformed/solver.hpp"

namespace pliant::total_lagrangian {

/// Advances a case by the total Lagrangian method.
template <class T, int D>
class Solver final : public undeformed::Solver<T, D> {
 public:
  /// Throws std::invalid_argument for what the method does not run.
  Solver(const Case& settings, const SolverOptions& options);

  double time_step() const override;
  std::size_t bytes() const override;

  BodyIntegrals integrals() override;
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
  Body<T, D>& body(int number) override { return state_.bodies.at(number); }
  const Body<T, D>& body(int number) const override { return state_.bodies.at(number); }
  void begin_step() override;
  void show() override { state_.age_memory(); }
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  void scale_mass();
  void check(const StepResult& result) const;

  State<T, D> state_;
  double stress_wave_speed_ = 0;  ///< what initial stresses add in squares to that of waves [m/s]
  Step<T, D> step_;
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::total_lagrangian
