#pragma once

#include "engine/method/registry.hpp"

namespace pliant::finite_elements {

/// The entry of this method in the registry.
RegisteredMethod method();

}  // namespace pliant::finite_elements
