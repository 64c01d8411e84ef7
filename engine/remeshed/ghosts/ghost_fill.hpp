#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/state.hpp"

namespace pliant::remeshed {

enum class WhichGhosts { all, reached };

/// Velocity and stress of a block's ghosts in stage buffer `stage` from the records of the surface
/// particles, (RP.45)-(RP.49), (RP.59).
template <class T, int D>
void fill_ghosts(Body<T, D>& body, int block, int stage, int parity, WhichGhosts which,
                 const Boundaries<D>& boundaries, const BoundaryValues<D>& values,
                 GhostTreatment treatment, const kernels::RemeshedTable<T, D>& kernels);

/// Density, material state and displacement of a block's ghosts by the linear fit (RP.43), and
/// v = h^d: what remeshing scatters.
template <class T, int D>
void fill_conserved(Body<T, D>& body, int block);

}  // namespace pliant::remeshed
