#pragma once

#include "engine/case/case.hpp"

namespace pliant::undeformed {

/// CFL number where the case gives none: the one that the method is good for, nine tenths of what
/// is stable by (PB.12) and (FE.6). Contact between bodies lets the energy grow with longer steps.
inline double default_cfl(const Case& a_case, double without_contact = 0.9) {
  return a_case.contacts.empty() ? without_contact : 0.6;
}

}  // namespace pliant::undeformed
