#pragma once

#include "engine/method/registry.hpp"

namespace pliant::point_based {

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::point_based
