#pragma once

#include "engine/remeshed/state/state.hpp"

// A remeshing smooths what lies between the nodes, so that it matters where they are. A body that a
// contact wall at rest throws back presses on the wall from nodes that stand still before it. Where
// the wall moves, the lattice moves with it, and the impact is the same seen from either (RP.76).
namespace pliant::remeshed {

/// Moves the lattices of bodies along with the contact walls nearest to them, by what these have
/// moved since the last remeshing, from `wall_offset`, which becomes the present one; particles
/// stay where they are. To be called when they are about to move onto the nodes. Periods stay where
/// they are, and all lattices where walls hold bodies.
template <class T, int D>
void move_lattices(State<T, D>& state, std::vector<Point<D>>& wall_offset);

extern template void move_lattices<double, 2>(State<double, 2>&, std::vector<Point<2>>&);
extern template void move_lattices<double, 3>(State<double, 3>&, std::vector<Point<3>>&);
extern template void move_lattices<float, 2>(State<float, 2>&, std::vector<Point<2>>&);
extern template void move_lattices<float, 3>(State<float, 3>&, std::vector<Point<3>>&);

}  // namespace pliant::remeshed
