#pragma once

#include "engine/case/method_rules.hpp"

namespace pliant::point_based {

/// Memory of nodes: bonds, halos with about as many points as there are nodes, searches, frames and
/// totals.
Footprint footprint(const Case& a_case, const BodyCase& body);

}  // namespace pliant::point_based
