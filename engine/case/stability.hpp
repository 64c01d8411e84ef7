#pragma once

#include <optional>
#include <string>

#include "engine/case/case.hpp"

/// How long a time step may be: waves of the material at rest, and the operators that carry them.
namespace pliant {

/// Speed of the fastest waves of the material at rest, (RP.12), in scaled mass [m/s].
double fastest_wave(const Case& a_case);

/// CFL number up to which steps of the case's method are stable, (RP.30) and (TL.9).
double stable_cfl(const Case& a_case);

/// Longest stable time step [s], by the fastest body at rest; none where the mass is scaled to the
/// step, and for methods without a known limit.
std::optional<double> stable_step(const Case& a_case);

/// "the time step 0.001 s (CFL number 2.9) is above the stability limit of 0.00079 s ..., and what
/// to do; empty for a case whose step is below it.
std::string stability_warning(const Case& a_case);

}  // namespace pliant
