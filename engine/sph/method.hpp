#pragma once

#include "engine/method/registry.hpp"

namespace pliant::sph {

RegisteredMethod method();

}  // namespace pliant::sph
