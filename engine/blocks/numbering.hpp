#pragma once

#include <span>
#include <vector>

#include "scheduler/blocks.hpp"

/// The blocks of all bodies in one numbering, body after body: what the step graph sees. A body may
/// be a lattice (engine/lattice/layout_blocks.hpp) or a cloud of points (point_blocks.hpp).
namespace pliant {

/// The body that a block of the step graph belongs to, and the block's number within it.
struct BlockOwner {
  int body, block;
};

/// Appends the owners of the blocks of a body, which follow those of the bodies before it.
void number_blocks(int body, int count, std::vector<BlockOwner>& owners);

/// The blocks of all bodies in one numbering; blocks of different bodies are no neighbours.
scheduler::Blocks join_blocks(std::span<const scheduler::Blocks> bodies);

}  // namespace pliant
