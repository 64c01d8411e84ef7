#pragma once

#include "engine/case/checks/check.hpp"
#include "engine/method/registry.hpp"

namespace pliant::point_based {

/// Adds problems of body `i` that no method with hyperelastic nodes can solve.
void check_body(const Check& check, std::size_t i);

RegisteredMethod method();

}  // namespace pliant::point_based
