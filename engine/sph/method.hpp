#pragma once

#include "engine/method/registry.hpp"

namespace pliant::sph {

/// The entry of this method in the registry.
RegisteredMethod method();

}  // namespace pliant::sph
