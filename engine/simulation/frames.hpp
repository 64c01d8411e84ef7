#pragma once

#include "engine/output/frame.hpp"
#include "engine/remeshed/solver.hpp"

namespace pliant {

/// The particles of a solver as viewers see them, ghosts as an option; with ghosts and contact
/// walls the pressure of these too, (RP.61). SI units; stresses have their zz component in plane
/// strain too.
template <class T, int D>
Frame take_frame(remeshed::Solver<T, D>& solver, bool with_ghosts);

}  // namespace pliant
