#pragma once

#include <string>
#include <vector>

namespace pliant::bench {

/// The machine of a measurement: processor and compiler, one line each.
std::vector<std::string> machine_description();

}  // namespace pliant::bench
