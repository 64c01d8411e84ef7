#pragma once

#include <cstdint>

#include "engine/method/solver.hpp"

namespace pliant::bench {

/// Duration of some steps [s].
struct Elapsed {
  double wall = 0;
  double processor = 0;  ///< of all threads

  /// The time for comparisons of programs: on one thread the processor time, which does not include
  /// other programs.
  double compared(int threads) const { return threads == 1 ? processor : wall; }
};

/// Whether the case of a solver has come to its end.
bool is_over(const Solver& solver);

/// Takes so many steps, at most up to the end of the case, each with its handicap (handicap.hpp).
Elapsed advance(Solver& solver, std::int64_t steps);

}  // namespace pliant::bench
