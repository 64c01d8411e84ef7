#include "engine/case/checks/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {

StepLimits step_limits(const Case& a_case) {
  const bool has_limits = a_case.rules != nullptr && a_case.rules->step_limits != nullptr;
  return has_limits ? a_case.rules->step_limits(a_case) : StepLimits{};
}

double scaled_wave_speed(const Case& a_case, const BodyCase& body) {
  return kernels::wave_speed_at_rest(body.material) / std::sqrt(step_limits(a_case).mass_scaling);
}

double fastest_wave(const Case& a_case) {
  double fastest = 0;
  for (const BodyCase& body : a_case.bodies) {
    fastest = std::max(fastest, kernels::wave_speed_at_rest(body.material));
  }
  return fastest / std::sqrt(step_limits(a_case).mass_scaling);
}

double stable_cfl(const Case& a_case) { return step_limits(a_case).stable_cfl; }

double cfl_number(const Case& a_case) {
  const StepLimits limits = step_limits(a_case);
  return a_case.time.cfl.value_or(std::min(limits.default_cfl, limits.stable_cfl));
}

std::optional<double> stable_step(const Case& a_case, double wave_speed) {
  const StepLimits limits = step_limits(a_case);
  if (!limits.bounds_given_steps || limits.mass_follows_step) return std::nullopt;
  const double present = wave_speed / std::sqrt(limits.mass_scaling);
  return limits.stable_cfl * a_case.discretisation.spacing /
         std::max(present, fastest_wave(a_case));
}

std::string stability_warning(const Case& a_case, double wave_speed) {
  const std::optional<double> at_rest = stable_step(a_case);
  const bool rests = at_rest && a_case.time.step && *a_case.time.step > *at_rest;
  const std::optional<double> limit = rests ? at_rest : stable_step(a_case, wave_speed);
  if (a_case.time.step && limit && *a_case.time.step > *limit) {
    return fmt::format(
        "the time step {:.4g} s is above the stability limit of {:.3g} s (CFL number {:.2g}){}; "
        "set "
        "time.step = \"cfl\", or to less than the limit",
        *a_case.time.step, *limit, stable_cfl(a_case),
        rests ? "" : fmt::format(" at the present wave speed of {:.4g} m/s", wave_speed));
  }
  if (!a_case.time.step && cfl_number(a_case) > stable_cfl(a_case)) {
    return fmt::format(
        "the CFL number {:.3g} is above the stability limit of {:.2g}; set time.cfl "
        "to less than the limit",
        cfl_number(a_case), stable_cfl(a_case));
  }
  return "";
}

}  // namespace pliant
