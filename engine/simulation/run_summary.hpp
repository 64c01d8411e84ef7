#pragma once

#include "engine/method/solver.hpp"
#include "engine/output/summary.hpp"

namespace pliant {

/// What a solver, its case and the program say about a run at its end: versions, particles, steps
/// and speed. The run itself adds its wall time, its start, the checks and the measurements.
Summary summary_of(const Case& settings, const SolverOptions& options, const Solver& solver);

}  // namespace pliant
