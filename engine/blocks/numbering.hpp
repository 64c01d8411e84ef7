#pragma once

#include <span>
#include <vector>

#include "scheduler/blocks.hpp"

/// The blocks of all bodies in one numbering, body after body, as in the step graph. A body may be
/// a lattice (engine/lattice/layout_blocks.hpp) or a cloud of points (point_blocks.hpp).
namespace pliant {

/// The body of a block of the step graph, and the number of the block in that body.
struct BlockOwner {
  int body, block;
};

/// Appends the owners of the blocks of a body.
void number_blocks(int body, int count, std::vector<BlockOwner>& owners);

/// The blocks of all bodies in one numbering; blocks of different bodies are not neighbours.
scheduler::Blocks join_blocks(std::span<const scheduler::Blocks> bodies);

}  // namespace pliant
