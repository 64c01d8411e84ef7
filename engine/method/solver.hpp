#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <pliant/field.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/boundaries/loads.hpp"
#include "engine/case/case.hpp"
#include "engine/method/body_integrals.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/method/step_clock.hpp"
#include "engine/output/archive/archive.hpp"
#include "engine/output/results/frame.hpp"
#include "kernels/isa.hpp"
#include "scheduler/step_graph.hpp"
#include "scheduler/step_record.hpp"
#include "scheduler/workers.hpp"

namespace pliant {

/// The resources that a solver runs on; results do not depend on them.
struct SolverOptions {
  int threads = 1;
  kernels::Isa isa = kernels::widest_supported();
};

/// The two sides of the energy balance (RP.72).
struct Balance {
  BodyIntegrals integrals;
  std::optional<EnergyBudget> budget;
};

/// A case and the method that advances it: the only interface between methods and the programs that
/// run them. It hides the scalar type and the dimension of the method.
class Solver {
 public:
  /// Throws std::invalid_argument unless `options.threads` is positive.
  Solver(const Case& settings, const SolverOptions& options);
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  const Case& settings() const { return settings_; }
  virtual const StepClock& clock() const = 0;
  /// Step length that the case requests [s], before it is adapted to the end of the run.
  virtual double time_step() const = 0;

  /// Length of the next step, of at most `longest` [s]. Throws StepFailure.
  double next_step(double longest) const;

  /// Advances one time step of at most `longest` [s]. Throws StepFailure.
  void step(double longest);
  /// Steps until the time is exactly `until` [s]. Throws StepFailure.
  void advance(double until);

  /// Whether look_ahead shows output times, so that no step has to end there.
  virtual bool shows_states_within_steps() const { return false; }
  /// Calls `look` with the state at `time` [s] within the next step, after a shorter step; then
  /// restores the present state, bit by bit. Throws StepFailure.
  virtual void look_ahead(double time, const std::function<void()>& look);

  virtual std::int64_t particles() const = 0;
  virtual std::int64_t ghosts() const { return 0; }
  virtual std::int64_t remeshings() const { return 0; }
  /// Size of all fields [B].
  virtual std::size_t bytes() const = 0;

  /// One value in SI units for each measurement of the case; NaN for those that evaluate histories
  /// and for missing surfaces. Forces are impulses since t = 0 [N s].
  std::vector<double> measure() { return measure_each(settings_.measurements); }
  double measure(std::size_t measurement) {
    return measure_each(std::span(settings_.measurements).subspan(measurement, 1))[0];
  }
  /// Whether measurements without a schedule are due at the present time.
  virtual bool is_measuring_due() const { return false; }
  /// A contact wall that has got between the particles of the surface of a body, or null.
  virtual const BoundaryCase* tool_inside() const { return nullptr; }
  /// Conserved quantities of all bodies together.
  virtual BodyIntegrals integrals() = 0;
  /// Work and losses since t = 0. Methods that do not account for them know them only for free
  /// bodies.
  virtual std::optional<EnergyBudget> energy_budget() const;
  /// Integrals and energy budget at one time, which is that of the velocities if positions have
  /// another one, so that the balance (RP.72) closes in every step.
  virtual Balance balance() { return {integrals(), energy_budget()}; }
  /// Whether the case has neither walls, loads, gravity, nor cuts that resist the blade.
  bool bodies_are_free() const;
  /// The particles at the present time, in SI units.
  virtual Frame frame(const FrameParts& parts) = 0;

  /// The loads of the boundaries; a caller may change them between steps.
  virtual Loads& loads() = 0;
  /// The runs of slots that hold the particles of a body, in ascending order.
  virtual std::vector<SlotRun> particle_runs(int body) const = 0;
  /// The fields of a body as they are in memory; valid until the next step.
  virtual std::vector<FieldView> fields(int body) const = 0;
  /// Positions of the particles of a body [m], in the order of its slots.
  virtual std::vector<std::array<double, 3>> positions(int body) const = 0;

  /// Writes everything that the next step reads and that set-up does not compute.
  void save(ArchiveWriter& archive) const;
  /// Restores a state into a solver that was made from the same case; the run continues bitwise.
  /// Throws OutputError when the archive is of another method or does not fit the case.
  void restore(const ArchiveReader& archive);

  /// Phases and dependencies of the next step.
  virtual const scheduler::StepGraph& step_graph() const = 0;
  /// Time spent in each phase since the solver was made.
  const scheduler::StepTotals& step_totals() const { return step_totals_; }
  /// Evaluations of the equation of motion since the solver was made, summed over the particles.
  std::int64_t particle_stages() const { return particle_stages_; }
  /// Wall time spent in `step` since the solver was made [s].
  double step_seconds() const { return step_seconds_; }
  scheduler::Workers& workers() { return workers_; }

  using GraphObserver = std::function<void(const scheduler::StepGraph& graph)>;
  /// Calls `observer` within the step after each graph that the solver has run, so that it can read
  /// the record of the graph. An empty function ends this.
  void observe_graphs(GraphObserver observer) { observe_graph_ = std::move(observer); }

 protected:
  /// Runs a graph and adds its record to the totals.
  void run(scheduler::StepGraph& graph);
  void add_particle_stages(std::int64_t count) { particle_stages_ += count; }

 private:
  /// Advances the state by `time_step` [s]. Throws StepFailure.
  virtual void take_step(double time_step) = 0;
  virtual std::vector<double> measure_each(std::span<const MeasurementCase> measurements) = 0;
  virtual void save_state(ArchiveWriter& archive) const = 0;
  virtual void restore_state(const ArchiveReader& archive) = 0;

  Case settings_;
  scheduler::Workers workers_;
  scheduler::StepTotals step_totals_;
  GraphObserver observe_graph_;
  std::int64_t particle_stages_ = 0;
  double step_seconds_ = 0;
};

}  // namespace pliant
