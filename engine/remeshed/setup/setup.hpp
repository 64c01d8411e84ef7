#pragma once

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// The lattice of a body: nodes lie symmetrically in its bounding box, so that a box whose sides
/// are whole multiples of the spacing has its surfaces half-way between nodes; periodic directions
/// start at the lower end of the cell.
template <int D>
Lattice<D> body_lattice(const Case& settings, const BodyCase& body);

/// The state before bodies have particles. It refers to the bodies of `settings`.
template <class T, int D>
State<T, D> make_state(const Case& settings);

}  // namespace pliant::remeshed
