#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/batch/designs.hpp"

namespace pliant::batch {

/// A run that is not done.
struct Waiting {
  Assignment parameters = {};
  std::string name = {};
  int attempts_left = 1;
  std::int64_t attempts = 0;  ///< number of attempts so far
  std::size_t bytes = 0;      ///< estimate; 0: not known yet
  double steps = 0;           ///< particles times steps, estimated with the bytes
};

}  // namespace pliant::batch
