#pragma once

#include <pliant/input.hpp>
#include <pliant/simulation.hpp>

#include <array>
#include <vector>

#include "engine/method/blades.hpp"
#include "engine/method/solver.hpp"

namespace pliant {

/// Durations of the last steps, and the expected duration of the next one.
class StepCosts {
 public:
  void add(double seconds);
  /// The longest of the last steps, for example one in which a blade moved [s]. It is limited to
  /// three times the median, so that a step during which other programs had the processor does not
  /// count.
  double expected() const { return expected_; }

 private:
  std::array<double, 16> latest_ = {};
  std::size_t count_ = 0;
  double expected_ = 0;
};

/// Inputs that wait for their time, and a record of those that have been applied. All actions of a
/// caller on the solver pass through it, so that the record is complete.
class Session {
 public:
  explicit Session(Solver& solver) : solver_(&solver) {}

  /// See Simulation. Throws std::invalid_argument and StepFailure.
  void enter(const Input& input);
  void play(const std::vector<Input>& inputs);
  void step();
  Progress advance(double until, double budget);

  const std::vector<Input>& record() const { return record_; }
  void forget() { record_.clear(); }

 private:
  bool has_come(double time) const;
  void apply(Input input);
  /// Steps towards `until` and records it. Returns the number of steps.
  std::int64_t run(double until, double deadline);
  /// Steps to `time` exactly like a run towards `until`.
  void repeat(double time, double until);
  void take_step(double longest);

  Solver* solver_;
  std::vector<Input> waiting_;  ///< in ascending order of time
  std::vector<Input> record_;
  StepCosts costs_;
};

/// The blades of a solver. Throws InputError for methods without cuts.
Blades& blades_of(Solver& solver);

/// The position of the boundary or cut that an input names. Throws InputError.
std::size_t target_of(const Case& settings, const Input& input);

}  // namespace pliant
