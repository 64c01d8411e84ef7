#pragma once

#include <vector>

#include "scheduler/phase.hpp"

namespace pliant::scheduler {

/// The blocks, the units that phases are divided into, and which of them are neighbours.
struct Blocks {
  /// [block] the other blocks that Reach::neighbours includes, without the block itself; symmetric.
  std::vector<std::vector<BlockId>> neighbours;

  int count() const { return static_cast<int>(neighbours.size()); }
};

}  // namespace pliant::scheduler
