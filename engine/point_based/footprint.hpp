#pragma once

#include "engine/case/method_rules.hpp"

namespace pliant::point_based {

/// Memory of nodes: bonds, and about as many points of halos as of nodes; search, frames and
/// totals.
Footprint footprint(const Case& a_case, const BodyCase& body);

}  // namespace pliant::point_based
