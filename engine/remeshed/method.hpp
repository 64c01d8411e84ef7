#pragma once

#include "engine/method/registry.hpp"

namespace pliant::remeshed {

/// The entry of this method in the registry.
RegisteredMethod method();

}  // namespace pliant::remeshed
