#pragma once

#include "engine/case/case.hpp"
#include "engine/method/step_clock.hpp"

namespace pliant {

/// The given time step of a case, else that of its CFL number, and of its largest strain where the
/// strain rate is known [1/s], (RP.29) [s].
double asked_step(const Case& settings, double wave_speed, double strain_rate = 0);

/// Length of the next step [s]: `asked`, or `longest` where that is shorter but for rounding.
/// Throws StepFailure when `asked` is next to nothing, or not a number.
double step_length(const Case& settings, const StepClock& clock, double asked, double longest);

}  // namespace pliant
