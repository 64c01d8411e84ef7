#pragma once

#include "engine/method/solver.hpp"
#include "engine/output/summary.hpp"

namespace pliant {

/// The summary of a run at its end, from the solver, its case and the program: versions, particles,
/// steps and speed. The run adds its wall time, its start, the checks and the measurements.
Summary summary_of(const Case& settings, const SolverOptions& options, const Solver& solver);

}  // namespace pliant
