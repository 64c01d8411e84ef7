#pragma once

#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/loads/wall_work.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

enum class WhichGhosts { all, reached };

/// Velocity and stress of a block's ghosts in stage buffer `stage` from the records of the surface
/// particles, (RP.45)-(RP.49), (RP.59). `work`, unless null, sums impulses and work of walls.
template <class T, int D>
void fill_ghosts(Body<T, D>& body, int block, int stage, int parity, WhichGhosts which,
                 const Surroundings<D>& around, GhostTreatment treatment,
                 const kernels::RemeshedTable<T, D>& kernels, WallWork<T, D>* work);

/// Density, material state and displacement of a block's ghosts by the linear fit (RP.43), and v =
/// h^d, for the scatter of a remeshing.
template <class T, int D>
void fill_conserved(Body<T, D>& body, int block);

}  // namespace pliant::remeshed
