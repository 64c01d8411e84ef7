#pragma once

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Finds for each block of a body the cells around its particles. Reads the layout, the masses, the
/// fractions and the fitted cells.
template <class T, int D>
void find_block_cells(Body<T, D>& body);

}  // namespace pliant::total_lagrangian
