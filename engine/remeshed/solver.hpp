#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/method/cached_graph.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/remeshed/neighbours/neighbours.hpp"
#include "engine/remeshed/remeshing/remesh.hpp"
#include "engine/remeshed/state.hpp"
#include "engine/remeshed/step.hpp"
#include "kernels/table.hpp"
#include "scheduler/step_graph.hpp"
#include "scheduler/step_record.hpp"
#include "scheduler/workers.hpp"

namespace pliant::remeshed {

/// A body's fields on nodes: what surface and integral measurements read.
template <class T, int D>
struct LatticeView {
  const Body<T, D>& body;
  const Population<T, D>& population;
  const FieldStore<T, D>& fields;
};

template <class T, int D>
class Measurer;

/// Advances a case by the remeshed method: steps, and remeshings when they are due.
template <class T, int D>
class Solver {
 public:
  using Measurer = remeshed::Measurer<T, D>;

  /// Throws std::invalid_argument for what the method does not run.
  Solver(const Case& settings, int threads, kernels::Isa isa);

  /// One time step, at most `longest` [s], and the remeshing that is due after it.
  /// Throws StepFailure.
  void step(double longest);

  /// Step length that the case asks for [s], before it is fitted to an output time.
  double time_step() const;

  const Clock& clock() const { return state_.clock; }
  State<T, D>& state() { return state_; }
  const State<T, D>& state() const { return state_; }
  const Case& settings() const { return settings_; }
  bool remeshes() const { return settings_.remeshing.policy != remeshing_never; }
  std::int64_t particles() const;
  std::int64_t ghosts() const;
  /// Whether particles have just come to lie on nodes: when measurements without a schedule are
  /// due.
  bool is_fresh() const { return state_.clock.steps_since_remeshing == 0; }
  std::size_t bytes() const;

  /// The bodies on fresh nodes at the present time: the particles themselves after a remeshing,
  /// else a remeshed copy; the particles stay as they are.
  std::vector<LatticeView<T, D>> on_nodes();
  /// Velocity and stress of the ghosts at the present state, for output.
  void refresh_ghosts();

  /// After the state has been read from a checkpoint.
  void restored();
  Remeshing<T, D>& remeshing(int body) { return *remeshings_[body]; }

  const kernels::Table<T, D>& kernels() const { return kernels_; }
  const scheduler::StepTotals& totals() const { return totals_; }
  /// Of the next step, unless it begins with a look for neighbours.
  const scheduler::StepGraph& step_graph() const { return *present_graph_; }
  scheduler::StepGraph& step_graph() { return *present_graph_; }
  scheduler::Workers& workers() { return workers_; }
  std::int64_t particle_stages() const { return particle_stages_; }
  double loop_seconds() const { return loop_seconds_; }

 private:
  static constexpr auto remeshing_never = decltype(Case{}.remeshing)::Policy::never;

  bool remeshing_due() const;
  void remesh();
  void remesh_onto_spare(bool reinitialise, bool is_final);
  std::vector<scheduler::Phase> source_phases();
  std::vector<scheduler::Phase> target_phases(bool from_particles);
  void adopt();
  void find_neighbours(double time_step);
  void add_strain(double time_step);
  void run(scheduler::StepGraph& graph);
  void check(const kernels::StageResult& result) const;
  void check_bodies() const;

  Case settings_;
  scheduler::Workers workers_;
  const kernels::Table<T, D>& kernels_;
  State<T, D> state_;
  Layouts<D> layouts_, spare_layouts_;  ///< of the present slots, and of the new lattice
  Step<T, D> step_;
  std::vector<std::unique_ptr<Remeshing<T, D>>> remeshings_;
  NeighbourSearch<T, D> search_;
  CachedGraph<D> step_graph_, listed_step_graph_, search_graph_;
  CachedGraph<D> ghost_graph_, source_graph_, target_graph_, stress_graph_;
  scheduler::StepGraph* present_graph_ = nullptr;  ///< one of the first two
  std::vector<bool> listed_;                       ///< [body] as the second was made for
  scheduler::StepTotals totals_;
  std::int64_t particle_stages_ = 0;
  double loop_seconds_ = 0;
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;

}  // namespace pliant::remeshed
