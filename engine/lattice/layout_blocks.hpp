#pragma once

#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/lattice/layout.hpp"

namespace pliant {

/// [body] the layouts of all bodies.
template <int D>
using Layouts = std::vector<const Layout<D>*>;

template <int D>
void number_blocks(const Layouts<D>& layouts, std::vector<BlockOwner>& owners);

/// Neighbours of each block, including those of its body up to `more` cells farther away.
template <int D>
scheduler::Blocks connect_blocks(const Layouts<D>& layouts, int more);

}  // namespace pliant
