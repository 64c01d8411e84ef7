#pragma once

#include <vector>

#include "scheduler/phase.hpp"

namespace pliant::scheduler {

/// Which blocks are near which: the units of ownership that phases are divided into.
struct Blocks {
  /// [block] the other blocks that Reach::neighbours includes, itself excluded; symmetric.
  std::vector<std::vector<BlockId>> neighbours;

  int count() const { return static_cast<int>(neighbours.size()); }
};

}  // namespace pliant::scheduler
