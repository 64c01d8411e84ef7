#pragma once

#include "engine/output/frame.hpp"
#include "engine/remeshed/solver.hpp"

namespace pliant {

/// The particles of a solver as viewers see them, ghosts and surfaces as an option; with ghosts and
/// contact walls the pressure of these too, (RP.61). SI units; stresses have their zz component in
/// plane strain too. Surfaces are those of nodes: between remeshings, of a remeshed copy.
template <class T, int D>
Frame take_frame(remeshed::Solver<T, D>& solver, bool with_ghosts, bool with_surface = false);

}  // namespace pliant
