#pragma once

#include <string>

#include "engine/method/solver.hpp"

namespace pliant {

/// Names two bodies that are inside each other at present and have no contact, and a remedy; empty
/// if there are none. Costs about as much as a step.
std::string passing_bodies_warning(const Solver& solver);

/// The same for two parts of one body, in methods with contact within a body. Costs as much as some
/// dozen steps.
std::string passing_parts_warning(const Solver& solver);

/// Names a contact wall that has got through the surface of a body, and a remedy; empty if there is
/// none.
std::string passing_tool_warning(const Solver& solver);

}  // namespace pliant
