#pragma once

#include "engine/method/registry.hpp"

namespace pliant::remeshed {

RegisteredMethod method();

}  // namespace pliant::remeshed
