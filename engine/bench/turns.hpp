#pragma once

#include <memory>

#include "engine/bench/row.hpp"
#include "engine/bench/standard_set.hpp"
#include "engine/method/solver.hpp"

namespace pliant::bench {

/// A row that is measured a few steps at a time, while another program waits.
class Turns {
 public:
  /// Sets the case up and takes the steps that are not measured.
  explicit Turns(Row row);

  /// Rate of the next steps of the row [particle-stages/s]: on one thread over the processor time,
  /// in which other programs have no share, on several over the wall time. A case that is over
  /// begins again.
  double next();

 private:
  void set_up();

  Row row_;
  std::unique_ptr<Solver> solver_;
};

/// Measures the row of this name: for each byte on standard input a turn, whose rate becomes a line
/// on standard output. Ends when the input does. Throws InputError where the set has no such row.
void answer_turns(const StandardSetOptions& options);

}  // namespace pliant::bench
