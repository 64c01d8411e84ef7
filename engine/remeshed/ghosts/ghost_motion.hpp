#pragma once

#include "engine/boundaries/boundary_values.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// Velocity of the ghosts that only drift: by (RP.43), (RP.59), or (RP.46) behind walls. It is u0
/// and u1 in stages 0 and 1, and (4 u1 - u0)/3 in the others. With these the Runge-Kutta method
/// moves them by dt u1, (RP.60).
template <class T, int D>
void drift_ghosts(Body<T, D>& body, int block, int stage, const BoundaryValues<D>& values,
                  GhostTreatment treatment, const kernels::RemeshedTable<T, D>& kernels);

/// Corrects the motion of ghosts in a stage: they move without the part (RP.50) of their velocity.
/// With the fit alone, (RP.60), they stay where the fit of positions is. Excludes slots that may
/// come into contact with a wall.
template <class T, int D>
void keep_on_fits(Body<T, D>& body, int block, int stage, double time_step,
                  const Boundaries<D>& boundaries);

}  // namespace pliant::remeshed
