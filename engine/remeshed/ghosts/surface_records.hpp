#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Writes the records of a block's surface particles, which ghosts read, at a stage. The first one
/// finds grad phi for all of them, `lead` ahead of it [s].
template <class T, int D>
void write_surface_records(Body<T, D>& body, int block, int stage, double lead,
                           const kernels::RemeshedTable<T, D>& kernels);

}  // namespace pliant::remeshed
