#pragma once

#include "engine/case/case.hpp"

namespace pliant::undeformed {

/// CFL number of nodes where the case gives none: nine tenths of what is stable by (PB.12) and
/// (FE.6). Contact between bodies lets the energy grow with longer steps.
inline double default_cfl_of_nodes(const Case& a_case) {
  return a_case.contacts.empty() ? 0.9 : 0.6;
}

}  // namespace pliant::undeformed
