#pragma once

#include <memory>

#include "engine/method/solver.hpp"
#include "engine/total_lagrangian/step.hpp"

namespace pliant::total_lagrangian {

/// Advances a case by the total Lagrangian method.
template <class T, int D>
class Solver final : public pliant::Solver {
 public:
  /// Throws std::invalid_argument for what the method does not run.
  Solver(const Case& settings, const SolverOptions& options);

  const Clock& clock() const override { return state_.clock; }
  double time_step() const override;
  std::int64_t particles() const override;
  std::size_t bytes() const override;

  BodyIntegrals integrals() override;
  std::optional<EnergyBudget> energy_budget() const override;
  Frame frame(const FrameParts& parts) override;

  Loads& loads() override { return state_.boundaries; }
  std::vector<SlotRun> particle_runs(int body) const override;
  std::vector<FieldView> fields(int body) const override;
  std::vector<std::array<double, 3>> positions(int body) const override;

  const scheduler::StepGraph& step_graph() const override { return *graph_; }
  scheduler::StepGraph& step_graph() { return *graph_; }
  State<T, D>& state() { return state_; }
  const State<T, D>& state() const { return state_; }

 private:
  void take_step(double time_step) override;
  void begin_step();
  void store_end();
  void move_to_output();
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  void scale_mass();
  void check(const StepResult& result) const;

  State<T, D> state_;
  Step<T, D> step_;
  std::unique_ptr<scheduler::StepGraph> graph_;
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::total_lagrangian
