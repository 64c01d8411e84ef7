#include "engine/method/step_length.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/checks/stability.hpp"
#include "engine/method/step_failure.hpp"

namespace pliant {

double asked_step(const Case& settings, double wave_speed, double strain_rate) {
  if (settings.time.step) return *settings.time.step;
  const double of_waves = cfl_number(settings) * settings.discretisation.spacing / wave_speed;
  return strain_rate > 0 ? std::min(of_waves, settings.time.strain / strain_rate) : of_waves;
}

double step_length(const Case& settings, const StepClock& clock, double asked, double longest) {
  constexpr double rounding = 1e-9,
                   shortest = 1e-12;  // relative to the step; to the length of the run
  if (asked > shortest * settings.time.end) {
    return asked > longest * (1 - rounding) ? longest : asked;
  }
  throw StepFailure(
      fmt::format("t = {:.6g}: the time step has collapsed to {:.3g} s (largest wave speed {:.3g} "
                  "m/s); check the material constants and the loading",
                  clock.time, asked, clock.wave_speed));
}

}  // namespace pliant
