#pragma once

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"

namespace pliant::remeshed {

/// The lattice of a body: nodes lie symmetrically in its bounding box, so that a box whose sides
/// are whole multiples of the spacing has its surfaces half-way between nodes; periodic directions
/// start at the lower end of the cell.
template <int D>
Lattice<D> body_lattice(const Case& settings, const BodyCase& body);

}  // namespace pliant::remeshed
