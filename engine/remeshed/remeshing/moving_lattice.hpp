#pragma once

#include "engine/remeshed/state/state.hpp"

// A remeshing smooths what is between the nodes, so the places of nodes matter. In an impact on a
// contact wall at rest, the nodes do not move relative to the wall. If the wall moves, the lattice
// moves with it, so that the impact is the same in both frames of reference, (RP.76).
namespace pliant::remeshed {

/// Moves the lattices of bodies with the nearest contact walls, by the motion of these since the
/// last remeshing. Particles do not move. Must be called before the particles are remeshed.
/// Lattices do not move in periodic directions, nor in cases where walls hold bodies.
template <class T, int D>
void move_lattices(State<T, D>& state);

extern template void move_lattices<double, 2>(State<double, 2>&);
extern template void move_lattices<double, 3>(State<double, 3>&);
extern template void move_lattices<float, 2>(State<float, 2>&);
extern template void move_lattices<float, 3>(State<float, 3>&);

}  // namespace pliant::remeshed
