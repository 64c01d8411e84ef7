#pragma once

#include <cstdint>

#include "engine/method/solver.hpp"

namespace pliant::bench {

/// Processor time of all threads of this process [s].
double processor_time();

/// Whether the case of a solver has come to its end.
bool is_over(const Solver& solver);

/// Takes so many steps, or those that are left of the case, each with its handicap (handicap.hpp).
void advance(Solver& solver, std::int64_t steps);

}  // namespace pliant::bench
