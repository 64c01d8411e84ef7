#pragma once

#include "engine/method/registry.hpp"

namespace pliant::sph {

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::sph
