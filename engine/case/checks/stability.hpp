#pragma once

#include <optional>
#include <string>

#include "engine/case/method_rules.hpp"

/// How long a time step may be: waves of the material at rest, and the operators that carry them.
namespace pliant {

/// What the method of the case says of its steps.
StepLimits step_limits(const Case& a_case);

/// Speed of waves in a body at rest, (RP.12), in scaled mass [m/s].
double scaled_wave_speed(const Case& a_case, const BodyCase& body);

/// The fastest of all bodies [m/s].
double fastest_wave(const Case& a_case);

/// CFL number up to which steps of the case's method are stable.
double stable_cfl(const Case& a_case);

/// CFL number of steps whose length follows from it: the one that the case gives, else that of the
/// method, and never more than stable_cfl.
double cfl_number(const Case& a_case);

/// Longest stable time step [s], by the fastest body at rest, or by `wave_speed` [m/s] where that
/// is higher; none where the mass is scaled to the step, and for methods without a known limit.
std::optional<double> stable_step(const Case& a_case, double wave_speed = 0);

/// "the time step 0.001 s (CFL number 2.9) is above the stability limit of 0.00079 s ..., and what
/// to do; empty for a case whose step is below it. `wave_speed` is that of a present state, where
/// it is higher than at rest [m/s].
std::string stability_warning(const Case& a_case, double wave_speed = 0);

}  // namespace pliant
