#pragma once

#include "engine/case/case.hpp"
#include "engine/method/step_clock.hpp"

namespace pliant {

/// The step that a case requests [s]: its given time step, or the one of its CFL number, (RP.29).
/// If the strain rate [1/s] is known, the largest strain of a step limits it too.
double asked_step(const Case& settings, double wave_speed, double strain_rate = 0);

/// Length of the next step [s]: `asked`, or `longest` if that is shorter or nearly equal. Throws
/// StepFailure when `asked` is almost zero or not a number.
double step_length(const Case& settings, const StepClock& clock, double asked, double longest);

}  // namespace pliant
