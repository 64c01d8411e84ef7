#pragma once

#include <string>

#include "engine/method/solver.hpp"

namespace pliant {

/// Names two bodies that are inside each other at present and have no contact, and a remedy; empty
/// if there are none. Costs about as much as a step.
std::string passing_bodies_warning(const Solver& solver);

}  // namespace pliant
