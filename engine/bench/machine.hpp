#pragma once

#include <string>
#include <vector>

namespace pliant::bench {

/// What a figure belongs to: the processor and the compiler, a line each.
std::vector<std::string> machine_description();

}  // namespace pliant::bench
