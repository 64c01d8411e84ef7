#pragma once

#include <optional>
#include <string>

#include "engine/case/method_rules.hpp"

/// Limits of the time step, from the waves of the material at rest and the operators of the method.
namespace pliant {

/// The step limits of the case's method.
StepLimits step_limits(const Case& a_case);

/// Speed of waves in a body at rest, (RP.12), with mass scaling [m/s].
double scaled_wave_speed(const Case& a_case, const BodyCase& body);

/// The largest wave speed of all bodies [m/s].
double fastest_wave(const Case& a_case);

/// CFL number up to which steps of the case's method are stable.
double stable_cfl(const Case& a_case);

/// CFL number for steps that follow from it: that of the case, or the default of the method; never
/// more than stable_cfl.
double cfl_number(const Case& a_case);

/// Longest stable time step [s], by the fastest body at rest, or by `wave_speed` [m/s] if that is
/// higher. None if the mass follows the step, and for methods without a known limit.
std::optional<double> stable_step(const Case& a_case, double wave_speed = 0);

/// "the time step 0.001 s (CFL number 2.9) is above the stability limit of 0.00079 s ...", and what
/// to do; empty if the step is below the limit. `wave_speed` [m/s] is that of a present state,
/// which may be higher than at rest.
std::string stability_warning(const Case& a_case, double wave_speed = 0);

}  // namespace pliant
