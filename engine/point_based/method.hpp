#pragma once

#include "engine/case/checks/check.hpp"
#include "engine/method/registry.hpp"

namespace pliant::point_based {

/// Adds what body `i` has and no method of hyperelastic nodes can do.
void check_body(const Check& check, std::size_t i);

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::point_based
