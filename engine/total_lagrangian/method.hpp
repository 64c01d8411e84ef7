#pragma once

#include "engine/method/registry.hpp"

namespace pliant::total_lagrangian {

RegisteredMethod method();

}  // namespace pliant::total_lagrangian
