#pragma once

#include "engine/method/registry.hpp"

namespace pliant::finite_elements {

RegisteredMethod method();

}  // namespace pliant::finite_elements
