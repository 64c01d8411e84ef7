#pragma once

#include "engine/method/cached_graph.hpp"
#include "engine/method/solver.hpp"
#include "engine/remeshed/neighbours/neighbours.hpp"
#include "engine/remeshed/remeshing/remeshings.hpp"
#include "engine/remeshed/state/state.hpp"
#include "engine/remeshed/state/state_copy.hpp"
#include "engine/sph/step.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::sph {

/// Advances a case by plain SPH: the state of the remeshed method without ghosts and remeshing,
/// with a neighbour search before every step.
template <class T, int D>
class Solver final : public pliant::Solver {
 public:
  /// Throws StepFailure for a body without particles.
  Solver(const Case& settings, const SolverOptions& options);

  const StepClock& clock() const override { return state_.clock; }
  double time_step() const override;
  std::int64_t particles() const override { return state_.particles(); }
  std::size_t bytes() const override {
    return state_.bytes() + step_.bytes() + before_look_.bytes();
  }
  bool shows_states_within_steps() const override { return true; }
  void look_ahead(double time, const std::function<void()>& look) override;

  BodyIntegrals integrals() override;
  std::optional<EnergyBudget> energy_budget() const override { return state_.energy; }
  Frame frame(const FrameParts& parts) override;

  Loads& loads() override { return state_.boundaries; }
  std::vector<SlotRun> particle_runs(int body) const override;
  std::vector<FieldView> fields(int body) const override;
  std::vector<std::array<double, 3>> positions(int body) const override;

  const scheduler::StepGraph& step_graph() const override { return *present_graph_; }
  scheduler::StepGraph& step_graph() { return *present_graph_; }
  remeshed::State<T, D>& state() { return state_; }
  const remeshed::State<T, D>& state() const { return state_; }

 private:
  void take_step(double time_step) override;
  void move(double time_step);
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  void number_slots();

  const kernels::RemeshedTable<T, D>& kernels_;
  remeshed::State<T, D> state_;
  remeshed::StateCopy<T, D> before_look_;
  Step<T, D> step_;
  remeshed::Remeshings<T, D> remeshings_;  ///< puts the initial particles on their lattices
  remeshed::NeighbourSearch<T, D> search_;
  CachedGraph<D> step_graph_, search_graph_;
  scheduler::StepGraph* present_graph_ = nullptr;
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::sph
