#pragma once

#include <memory>

#include "engine/bench/row.hpp"
#include "engine/bench/standard_set.hpp"
#include "engine/method/solver.hpp"

namespace pliant::bench {

/// A row that is measured a few steps at a time, in alternation with another program.
class Turns {
 public:
  /// Sets up the case and takes the steps that are not measured.
  explicit Turns(Row row);

  /// Rate of the next steps of the row [particle-stages/s]: on one thread relative to the processor
  /// time, which does not include other programs; on several, to the wall time. A case that has
  /// ended starts again.
  double next();

 private:
  void set_up();

  Row row_;
  std::unique_ptr<Solver> solver_;
};

/// Measures the row with this name: one turn for each byte on standard input, with its rate as a
/// line on standard output. Ends when the input ends. Throws InputError if the set has no such row.
void answer_turns(const StandardSetOptions& options);

}  // namespace pliant::bench
