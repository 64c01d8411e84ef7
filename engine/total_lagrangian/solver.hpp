#pragma once

#include <cstdint>
#include <memory>

#include "engine/total_lagrangian/step.hpp"
#include "scheduler/step_graph.hpp"
#include "scheduler/step_record.hpp"
#include "scheduler/workers.hpp"

namespace pliant::total_lagrangian {

template <class T, int D>
class Measurer;

/// Advances a case by the total Lagrangian method.
template <class T, int D>
class Solver {
 public:
  using Measurer = total_lagrangian::Measurer<T, D>;

  /// Throws std::invalid_argument for what the method does not run.
  Solver(const Case& settings, int threads, kernels::Isa isa);

  /// One time step, at most `longest` [s]. Throws StepFailure.
  void step(double longest);

  /// Step length that the case asks for [s], before it is fitted to an output time.
  double time_step() const;

  const Clock& clock() const { return state_.clock; }
  State<T, D>& state() { return state_; }
  const State<T, D>& state() const { return state_; }
  const Case& settings() const { return settings_; }
  std::int64_t particles() const;
  std::int64_t ghosts() const { return 0; }
  /// Whether this is an instant of its own accord for measurements that have no schedule.
  bool is_fresh() const { return false; }

  const scheduler::StepTotals& totals() const { return totals_; }
  const scheduler::StepGraph& step_graph() const { return *graph_; }
  scheduler::StepGraph& step_graph() { return *graph_; }
  scheduler::Workers& workers() { return workers_; }
  std::int64_t particle_stages() const { return particle_stages_; }
  double loop_seconds() const { return loop_seconds_; }

 private:
  void scale_mass();
  void check(const StepResult& result) const;

  Case settings_;
  scheduler::Workers workers_;
  State<T, D> state_;
  Step<T, D> step_;
  std::unique_ptr<scheduler::StepGraph> graph_;
  scheduler::StepTotals totals_;
  std::int64_t particle_stages_ = 0;
  double loop_seconds_ = 0;
};

extern template class Solver<double, 2>;
extern template class Solver<double, 3>;

}  // namespace pliant::total_lagrangian
