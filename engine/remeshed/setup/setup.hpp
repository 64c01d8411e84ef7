#pragma once

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// The lattice of a body. Nodes are placed symmetrically in its bounding box, so that the surfaces
/// of a box are half-way between nodes if its sides are multiples of the spacing. Periodic
/// directions start at the lower end of the cell.
template <int D>
Lattice<D> body_lattice(const Case& settings, const BodyCase& body);

/// The state before bodies have particles. It refers to the bodies of `settings`.
template <class T, int D>
State<T, D> make_state(const Case& settings);

}  // namespace pliant::remeshed
