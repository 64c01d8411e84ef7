#pragma once

#include "engine/method/registry.hpp"

namespace pliant {

/// The methods that come with the program: the list in methods.cpp is the one place that names
/// them all.
const MethodRegistry& methods();

}  // namespace pliant
