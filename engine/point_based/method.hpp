#pragma once

#include "engine/case/check.hpp"
#include "engine/method/registry.hpp"

namespace pliant::point_based {

/// Adds what body `i` has and no method of hyperelastic nodes can do.
void check_body(const Check& check, std::size_t i);

/// Default CFL number of nodes that nothing pushes one by one; contact between bodies lets the
/// energy grow with longer steps.
double cfl_of_nodes(const Case& a_case);

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::point_based
