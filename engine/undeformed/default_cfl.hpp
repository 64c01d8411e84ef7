#pragma once

#include <algorithm>

#include "engine/case/case.hpp"

namespace pliant::undeformed {

/// CFL number of nodes where the case gives none: nine tenths of what is stable by (PB.12) and
/// (FE.6). Contact, with walls too, lets the energy grow with longer steps: by 7 to 10 % of the
/// work of a round tool that slides on a block without friction with 0.9, by 0.4 to 0.9 % with 0.6.
inline double default_cfl_of_nodes(const Case& a_case) {
  const bool meets_walls = std::ranges::any_of(a_case.boundaries, [](const BoundaryCase& wall) {
    return wall.kind == BoundaryCase::Kind::contact_wall;
  });
  return meets_walls || !a_case.contacts.empty() ? 0.6 : 0.9;
}

}  // namespace pliant::undeformed
