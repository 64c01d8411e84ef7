#pragma once

#include <memory>

#include "engine/method/solver.hpp"
#include "engine/point_based/body_cuts.hpp"
#include "engine/point_based/step.hpp"

namespace pliant::point_based {

/// Advances a case by the point-based method.
template <class T, int D>
class Solver final : public pliant::Solver {
 public:
  /// Throws InputError for bodies that hold no nodes.
  Solver(const Case& settings, const SolverOptions& options);

  const Clock& clock() const override { return state_.clock; }
  /// What is left of a step that an output time divides, else (PB.12).
  double time_step() const override;
  std::int64_t particles() const override;
  std::size_t bytes() const override;

  BodyIntegrals integrals() override;
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
  void cut(double time);
  void store_end();
  void move_to_output();
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  void check(const StepResult& result) const;

  State<T, D> state_;
  Step<T, D> step_;
  std::vector<std::unique_ptr<BodyCuts<T, D>>> cuts_;  ///< [body] null: none
  std::unique_ptr<scheduler::StepGraph> graph_;
  double resolution_;  ///< the least H of all bodies [m]
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::point_based
