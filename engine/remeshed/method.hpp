#pragma once

#include "engine/method/registry.hpp"

namespace pliant::remeshed {

/// What the registry knows of this method.
RegisteredMethod method();

}  // namespace pliant::remeshed
