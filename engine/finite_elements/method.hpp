#pragma once

#include "engine/method/registry.hpp"

namespace pliant::finite_elements {

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::finite_elements
