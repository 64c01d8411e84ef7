#pragma once

#include <pliant/pliant.hpp>

namespace pliant {

inline SimulationOptions one_thread() {
  SimulationOptions options;
  options.threads = 1;
  return options;
}

}  // namespace pliant
