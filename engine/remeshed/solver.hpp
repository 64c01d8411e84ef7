#pragma once

#include <optional>
#include <vector>

#include "engine/method/cached_graph.hpp"
#include "engine/method/solver.hpp"
#include "engine/remeshed/neighbours/neighbours.hpp"
#include "engine/remeshed/observe/measure.hpp"
#include "engine/remeshed/remeshing/remeshings.hpp"
#include "engine/remeshed/state/lattice_view.hpp"
#include "engine/remeshed/state/state.hpp"
#include "engine/remeshed/state/state_copy.hpp"
#include "engine/remeshed/step.hpp"
#include "kernels/remeshed/table.hpp"

namespace pliant::remeshed {

/// Advances a case by the remeshed method.
template <class T, int D>
class Solver final : public pliant::Solver {
 public:
  /// Throws StepFailure for a body without particles.
  Solver(const Case& settings, const SolverOptions& options);

  const Clock& clock() const override { return state_.clock; }
  double time_step() const override;
  std::int64_t particles() const override { return state_.particles(); }
  std::int64_t ghosts() const override;
  std::int64_t remeshings() const override { return state_.clock.remeshings; }
  std::size_t bytes() const override { return state_.bytes() + before_look_.bytes(); }
  bool shows_states_within_steps() const override { return true; }
  void look_ahead(double time, const std::function<void()>& look) override;

  /// True after a remeshing, when particles lie on nodes.
  bool is_measuring_due() const override { return lies_on_nodes(); }
  BodyIntegrals integrals() override;
  std::optional<EnergyBudget> energy_budget() const override { return state_.energy; }
  Frame frame(const FrameParts& parts) override;

  Loads& loads() override { return state_.boundaries; }
  std::vector<SlotRun> particle_runs(int body) const override;
  std::vector<FieldView> fields(int body) const override;
  std::vector<std::array<double, 3>> positions(int body) const override;

  /// The graph of the next step, unless that step begins with a search for neighbours.
  const scheduler::StepGraph& step_graph() const override { return *present_graph_; }
  scheduler::StepGraph& step_graph() { return *present_graph_; }
  State<T, D>& state() { return state_; }
  const State<T, D>& state() const { return state_; }
  Remeshing<T, D>& remeshing(int body) { return remeshings_[body]; }

  /// The present bodies on lattice nodes: the particles after a remeshing, else a remeshed copy.
  std::vector<LatticeView<T, D>> on_nodes();
  /// Computes velocity and stress of the ghosts at the present state, for output.
  void refresh_ghosts();

 private:
  void take_step(double time_step) override;
  void move(double time_step);
  double bound_of_initial_strain_rate();
  /// The measurer of the present state. One remeshing serves all measurements of a state.
  Measurer<T, D>& measurer();
  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override;
  void save_state(ArchiveWriter& archive) const override;
  void restore_state(const ArchiveReader& archive) override;
  bool lies_on_nodes() const { return state_.clock.steps_since_remeshing == 0; }
  void remesh();
  void remesh_onto_spare(bool reinitialise, bool is_final);
  std::vector<scheduler::Phase> source_phases();
  void use_new_slots();
  void number_slots();
  void find_neighbours(double time_step);
  void check_layouts();

  const kernels::RemeshedTable<T, D>& kernels_;
  State<T, D> state_;
  StateCopy<T, D> before_look_;
  Step<T, D> step_;
  Remeshings<T, D> remeshings_;
  NeighbourSearch<T, D> search_;
  CachedGraph<D> step_graph_, listed_step_graph_, search_graph_;
  CachedGraph<D> ghost_graph_, source_graph_, target_graph_, stress_graph_;
  scheduler::StepGraph* present_graph_ = nullptr;  ///< one of the first two
  std::vector<bool> listed_;  ///< [body] whether it used lists when the second graph was made
  std::optional<Measurer<T, D>> measurer_;  ///< until the state changes
  double slowing_;  ///< factor by which the scaled mass slows waves, (RP.87)
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;
extern template class Solver<float, 2>;
extern template class Solver<float, 3>;

}  // namespace pliant::remeshed
