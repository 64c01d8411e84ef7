#pragma once

#include "engine/case/method_rules.hpp"

namespace pliant::remeshed {

/// Memory of particles on a lattice: of slots by the list of fields, of ghosts with their fits and
/// of particles, which are in frames and in the cells over which totals are integrated, as
/// measured.
Footprint footprint(const Case& a_case, const BodyCase& body);

}  // namespace pliant::remeshed
