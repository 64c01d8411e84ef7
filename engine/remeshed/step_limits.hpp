#pragma once

#include "engine/case/method_rules.hpp"

namespace pliant::remeshed {

/// Stable steps of particles on a lattice with Runge-Kutta 4, (RP.30). `default_cfl` is for cases
/// that do not set a CFL number.
StepLimits step_limits(const Case& a_case, double default_cfl);

}  // namespace pliant::remeshed
