#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/padded.hpp"
#include "engine/method/field_views.hpp"
#include "engine/method/solver.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/undeformed/advance.hpp"
#include "engine/undeformed/body.hpp"
#include "engine/undeformed/state.hpp"
#include "engine/undeformed/state_archive.hpp"
#include "engine/undeformed/within_step.hpp"
#include "kernels/material.hpp"

namespace pliant::undeformed {

/// The common solver of methods on the undeformed body: it combines the state, the step and the
/// measurer of a method. The namespace of the state also has take_frame(state, parts), and
/// slot_runs(body) and present_positions(body) for its bodies.
///
/// A step always has its full length, so that no output time alters a run: an occasional short step
/// would excite vibrations. At an output time inside a step, particles are shown on their way
/// through it: within_step.hpp.
template <class State, class Step, class Measurer>
class Solver : public pliant::Solver {
  using Body = typename decltype(State::bodies)::value_type;
  using T = typename Body::Scalar;
  static constexpr int D = Body::dimension;

 public:
  const Clock& clock() const override { return state_.clock; }
  double time_step() const override;
  std::int64_t particles() const override;
  const BoundaryCase* tool_inside() const override { return state_.tool_inside; }
  std::size_t bytes() const override;

  std::optional<EnergyBudget> energy_budget() const override;
  Balance balance() override;
  BodyIntegrals integrals() override { return measurer().totals(); }
  Frame frame(const FrameParts& parts) override { return take_frame(state_, parts); }

  Loads& loads() override { return state_.boundaries; }
  std::vector<FieldView> fields(int body) const override;
  std::vector<SlotRun> particle_runs(int body) const override {
    return slot_runs(state_.bodies.at(body));
  }
  std::vector<std::array<double, 3>> positions(int body) const override {
    return present_positions(state_.bodies.at(body));
  }

  const scheduler::StepGraph& step_graph() const override { return *graph_; }
  scheduler::StepGraph& step_graph() { return *graph_; }
  State& state() { return state_; }
  const State& state() const { return state_; }

 protected:
  using StepResult = decltype(std::declval<Step&>().fold());

  /// Makes a state with empty bodies and the wave speed of their materials.
  Solver(const Case& a_case, const SolverOptions& options);

  /// Sets the phases of a step; all bodies must exist, and `blocks` are their blocks.
  void set_step(std::unique_ptr<Step> step, const scheduler::Blocks& blocks);

  void save_state(ArchiveWriter& archive) const override { put_state(archive, state_); }
  void restore_state(const ArchiveReader& archive) override;

 private:
  /// Length of the step by the CFL number of the case [s].
  virtual double automatic_step() const = 0;
  virtual Measurer measurer() = 0;
  /// Whether velocities belong to the middle of a step, not to its end.
  virtual bool velocities_lag() const = 0;
  /// Whether the work of all forces and all losses are known.
  virtual bool knows_energy() const { return true; }
  /// Whether the damping rate is adaptive, (TL.10), (PB.65).
  virtual bool has_adaptive_damping() const = 0;
  /// The failure of a step whose result is not finite.
  virtual StepFailure failure(const StepResult& result) const = 0;
  StepFailure failure(const Overlap& overlap) const;
  /// Adapts the next step to the result of this one.
  virtual void adapt(const Advance&, const StepResult&) {}
  /// Called when the time of the clock has changed.
  virtual void show() {}

  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override {
    return measurer()(measurements);
  }
  void take_step(double time_step) override;
  void begin_step();
  void damp_critically(const Advance& advance, const Secant& secant);
  void move_to_output();

  State state_;
  std::unique_ptr<Step> step_;
  std::unique_ptr<scheduler::StepGraph> graph_;
};

template <class State, class Step, class Measurer>
Solver<State, Step, Measurer>::Solver(const Case& a_case, const SolverOptions& options)
    : pliant::Solver(a_case, options), state_(settings()) {
  state_.bodies.resize(settings().bodies.size());
  for (const BodyCase& body : settings().bodies) {
    state_.clock.wave_speed =
        std::max(state_.clock.wave_speed, kernels::wave_speed_at_rest(body.material));
  }
}

template <class State, class Step, class Measurer>
void Solver<State, Step, Measurer>::set_step(std::unique_ptr<Step> step,
                                             const scheduler::Blocks& blocks) {
  step_ = std::move(step);
  graph_ = std::make_unique<scheduler::StepGraph>(step_->phases(), blocks, Step::resources());
}

// If walls hold all particles, only the end of the run limits the step.
template <class State, class Step, class Measurer>
double Solver<State, Step, Measurer>::time_step() const {
  if (settings().time.step) return *settings().time.step;
  const double step = automatic_step();
  return std::isfinite(step) ? step : settings().time.end;
}

template <class State, class Step, class Measurer>
std::int64_t Solver<State, Step, Measurer>::particles() const {
  std::int64_t sum = 0;
  for (const auto& body : state_.bodies) sum += body.particles;
  return sum;
}

template <class State, class Step, class Measurer>
std::size_t Solver<State, Step, Measurer>::bytes() const {
  std::size_t sum = 0;
  for (const auto& body : state_.bodies) sum += body.bytes();
  return sum;
}

template <class State, class Step, class Measurer>
std::optional<EnergyBudget> Solver<State, Step, Measurer>::energy_budget() const {
  if (!knows_energy()) return std::nullopt;
  EnergyBudget present = state_.energy;
  add(present, state_.power, state_.clock.lag());
  return present;
}

// From rest, the kinetic energy grows with the square of the time: extrapolated from the middle or
// the end, the budget of a run of one step would miss all of it.
template <class State, class Step, class Measurer>
Balance Solver<State, Step, Measurer>::balance() {
  Clock& clock = state_.clock;
  const double time = clock.time;
  if (!velocities_lag()) {
    const bool is_within = clock.rest() > 0;
    clock.time = clock.step_end;
    if (is_within) move_to_output();
    const Balance at_end = {integrals(), energy_budget()};
    clock.time = time;
    if (is_within) move_to_output();
    return at_end;
  }
  const AtVelocityTime<Body> at_velocity_time(state_.bodies, clock.lag());
  clock.time = clock.velocity_time;
  const Balance balance = {integrals(), energy_budget()};
  clock.time = time;
  return balance;
}

template <class State, class Step, class Measurer>
std::vector<FieldView> Solver<State, Step, Measurer>::fields(int body) const {
  const auto& shown = state_.bodies.at(body);
  return {field_view<T>("displacement", "m", shown.displacement, shown.slots),
          field_view<T>("velocity", "m/s", shown.velocity, shown.slots),
          field_view<T>("mass", "kg", std::span(&shown.mass, 1), shown.slots)};
}

template <class State, class Step, class Measurer>
void Solver<State, Step, Measurer>::restore_state(const ArchiveReader& archive) {
  get_state(archive, state_);
  show();
}

template <class State, class Step, class Measurer>
void Solver<State, Step, Measurer>::take_step(double dt) {
  Clock& clock = state_.clock;
  const double rest = clock.rest();
  const bool begins = rest == 0;
  if (begins && dt < time_step()) {
    for (Body& body : state_.bodies) store_start<T, D>(body, velocities_lag());
  }
  if (begins) begin_step();
  clock.time = begins || dt < rest - clock.rounding() ? clock.time + dt : clock.step_end;
  if (begins && clock.rest() > 0) {
    for (Body& body : state_.bodies) store_end<T, D>(body, velocities_lag());
  }
  if (!begins || clock.rest() > 0) move_to_output();
  show();
}

template <class State, class Step, class Measurer>
void Solver<State, Step, Measurer>::move_to_output() {
  for (Body& body : state_.bodies) {
    undeformed::move_to_output<T, D>(body, state_.clock, velocities_lag());
  }
}

template <class State, class Step, class Measurer>
StepFailure Solver<State, Step, Measurer>::failure(const Overlap& overlap) const {
  const auto& bodies = settings().contacts[overlap.contact].bodies;
  const Point<D> place = unpadded<D>(overlap.place);
  const std::vector<std::string> later = {smaller_step(settings()), "let them meet more slowly",
                                          "use a finer spacing"};
  return failed_step(
      settings(), clock(),
      fmt::format("bodies `{}` and `{}` overlap by {:.3g} at {}", settings().bodies[bodies[0]].name,
                  settings().bodies[bodies[1]].name, overlap.depth, coordinates<D>(place)),
      clock().step > 0 ? later : std::vector<std::string>{"let them at most meet at the start"});
}

/// Sets the rate of adaptive damping after a step that has taken a sample, (TL.10), and when to
/// take the next one.
template <class State, class Step, class Measurer>
void Solver<State, Step, Measurer>::damp_critically(const Advance& advance, const Secant& secant) {
  Clock& clock = state_.clock;
  const auto wait = [&](double omega) {
    clock.sample_interval = steps_until_sample(omega, advance.length, clock.sample_interval);
  };
  if (secant.inertia > 0) {
    const double omega = std::sqrt(secant.frequency2() / clock.mass_scaling);
    clock.damping = std::min(2 * omega, 1 / advance.length);
    wait(omega);
  } else if (secant.inertia_in_rounding > 0) {
    const double most = std::sqrt(secant.most_frequency2() / clock.mass_scaling);
    clock.damping = std::min(clock.damping, 2 * most);
    wait(clock.damping / 2);
  }
  clock.next_sample += clock.sample_interval;
}

/// Takes a whole step, and sets its length and its end in the clock.
template <class State, class Step, class Measurer>
void Solver<State, Step, Measurer>::begin_step() {
  // In that many steps, waves travel only a few cells and the state hardly changes.
  constexpr int examine_every = 8;
  Clock& clock = state_.clock;
  const Advance advance = {clock.step_end, clock.step_length, time_step(),
                           clock.step % examine_every == 0,
                           has_adaptive_damping() && clock.step == clock.next_sample};
  step_->prepare(advance);
  run(*graph_);
  const StepResult result = step_->fold();
  if (result.non_finite >= 0) throw failure(result);
  if (result.overlap) throw failure(*result.overlap);
  for (Wall<D>& wall : state_.boundaries.walls) wall.move(advance.time, advance.length);
  clock.step_length = advance.length;
  clock.step_end = advance.time + advance.length;
  clock.velocity_time = velocities_lag() ? clock.step_end - advance.length / 2 : clock.step_end;
  ++clock.step;
  if (advance.samples) damp_critically(advance, result.secant);
  adapt(advance, result);
  add_particle_stages(particles());
}

}  // namespace pliant::undeformed
