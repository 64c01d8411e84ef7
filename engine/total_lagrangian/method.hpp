#pragma once

#include "engine/method/registry.hpp"

namespace pliant::total_lagrangian {

/// The entry of this method in the registry.
RegisteredMethod method();

}  // namespace pliant::total_lagrangian
