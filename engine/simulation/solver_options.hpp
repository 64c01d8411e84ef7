#pragma once

#include <string>

#include "engine/method/solver.hpp"

namespace pliant {

/// What a user asks for: 0 threads are one for each processor, an empty `isa` is the widest that
/// the processor has. Throws std::invalid_argument for what this machine cannot do.
SolverOptions solver_options(int threads, const std::string& isa);

}  // namespace pliant
