#pragma once

#include <vector>

#include "engine/lattice/layout.hpp"
#include "scheduler/blocks.hpp"

/// The blocks of all bodies in one numbering, body after body: what the step graph sees.
namespace pliant {

/// Where a block of the step graph belongs.
struct BlockOwner {
  int body, block;
};

/// [body]
template <int D>
using Layouts = std::vector<const Layout<D>*>;

template <int D>
void number_blocks(const Layouts<D>& layouts, std::vector<BlockOwner>& owners);

/// Neighbours of each block, and those of its body up to `more` cells farther away.
template <int D>
scheduler::Blocks connect_blocks(const Layouts<D>& layouts, int more);

}  // namespace pliant
