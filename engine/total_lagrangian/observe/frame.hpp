#pragma once

#include "engine/output/frame.hpp"
#include "engine/total_lagrangian/solver.hpp"

namespace pliant {

/// The particles of a solver as viewers see them, in SI units. Stress, pressure and dilatation are
/// the means over the stress points around a particle. There are no ghosts to show.
template <class T, int D>
Frame take_frame(total_lagrangian::Solver<T, D>& solver, bool with_ghosts,
                 bool with_surface = false);

}  // namespace pliant
