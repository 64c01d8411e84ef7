#pragma once

#include <pliant/input.hpp>
#include <pliant/simulation.hpp>

#include <array>
#include <vector>

#include "engine/method/blades.hpp"
#include "engine/method/solver.hpp"

namespace pliant {

/// What the latest steps took, and what the next one must be expected to take.
class StepCosts {
 public:
  void add(double seconds);
  /// The longest of the latest steps, such as one in which a blade moved; but no more than three
  /// times the median, so that a step during which other programs had the processor does not count
  /// [s].
  double expected() const { return expected_; }

 private:
  std::array<double, 16> latest_ = {};
  std::size_t count_ = 0;
  double expected_ = 0;
};

/// Inputs of a simulation on their way in, and the record of those that have entered. Everything
/// that a caller does to the solver passes here, so that the record lacks nothing.
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
  /// Steps towards `until` and records that; returns the steps.
  std::int64_t run(double until, double deadline);
  /// Steps to `time` exactly as a run towards `until` did.
  void repeat(double time, double until);
  void take_step(double longest);

  Solver* solver_;
  std::vector<Input> waiting_;  ///< ascending in time
  std::vector<Input> record_;
  StepCosts costs_;
};

/// The blades of a solver. Throws InputError for methods without cuts.
Blades& blades_of(Solver& solver);

/// The position of the boundary or cut that an input names. Throws InputError.
std::size_t target_of(const Case& settings, const Input& input);

}  // namespace pliant
