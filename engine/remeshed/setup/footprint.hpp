#pragma once

#include "engine/case/method_rules.hpp"

namespace pliant::remeshed {

/// Memory of particles on a lattice. That of slots follows from the list of fields; that of ghosts
/// with their fits is measured, and so is that of particles in frames and in the cells for
/// integrals.
Footprint footprint(const Case& a_case, const BodyCase& body);

}  // namespace pliant::remeshed
