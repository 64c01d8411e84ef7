#pragma once

#include "engine/case/case.hpp"
#include "engine/case/placement.hpp"

namespace pliant::undeformed {

/// Default CFL number of nodes: nine tenths of what is stable by (PB.12) and (FE.6). With contact,
/// also with walls, longer steps increase the energy: for a round tool that slides on a block
/// without friction, by 7 to 10 % of its work at 0.9, by 0.4 to 0.9 % at 0.6.
inline double default_cfl_of_nodes(const Case& a_case) {
  const bool meets_walls = has_boundary(a_case, BoundaryCase::Kind::contact_wall);
  return meets_walls || !a_case.contacts.empty() ? 0.6 : 0.9;
}

}  // namespace pliant::undeformed
