#pragma once

#include <cstdint>

#include "engine/method/solver.hpp"

namespace pliant::bench {

/// How long some steps took [s].
struct Elapsed {
  double wall = 0;
  double processor = 0;  ///< of all threads

  /// The time by which programs compare: on one thread that of the processor, in which other
  /// programs have no share.
  double compared(int threads) const { return threads == 1 ? processor : wall; }
};

/// Whether the case of a solver has come to its end.
bool is_over(const Solver& solver);

/// Takes so many steps, or those that are left of the case, each with its handicap (handicap.hpp).
Elapsed advance(Solver& solver, std::int64_t steps);

}  // namespace pliant::bench
