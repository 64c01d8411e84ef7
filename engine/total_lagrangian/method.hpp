#pragma once

#include "engine/method/registry.hpp"

namespace pliant::total_lagrangian {

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::total_lagrangian
