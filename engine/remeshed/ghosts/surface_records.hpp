#pragma once

#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Writes the records of a block's surface particles at a stage, for ghosts. The first stage also
/// computes grad phi, at the time `lead` [s] after it.
template <class T, int D>
void write_surface_records(Body<T, D>& body, int block, int stage, double lead,
                           const kernels::RemeshedTable<T, D>& kernels);

}  // namespace pliant::remeshed
