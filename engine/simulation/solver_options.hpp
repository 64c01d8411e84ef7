#pragma once

#include <string>

#include "engine/method/solver.hpp"

namespace pliant {

/// Options of a user: 0 threads mean one for each processor, an empty `isa` the widest one of the
/// processor. Throws InputError for what this machine does not support.
SolverOptions solver_options(int threads, const std::string& isa);

}  // namespace pliant
