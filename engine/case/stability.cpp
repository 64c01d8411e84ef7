#include "engine/case/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// (RP.30). A plane wave of the wave number k has the rates lambda = -kappa delta^4(k) +- i c g(k),
// g(k) the gradient operator's answer to it. Runge-Kutta 4 is stable up to 2 sqrt(2) on the
// imaginary axis and up to 2.785 on the real one.
namespace pliant {

namespace {

constexpr double on_imaginary_axis = 2.8284271247461903, on_real_axis = 2.785;
// Free surfaces and walls ask for shorter steps than the interior, as measured.
constexpr double near_surfaces = 0.75;

/// max_k h abs(g(k)) on the square and on the cubic lattice.
double largest_response(kernels::Weight kernel, int dimension) {
  const bool plane = dimension == 2;
  switch (kernel) {
    case kernels::Weight::quartic:
      return plane ? 0.951 : 0.971;
    case kernels::Weight::quartic_polynomial:
      return plane ? 0.920 : 0.946;
    case kernels::Weight::compact:
      return plane ? 1.251 : 1.400;
    case kernels::Weight::fourth_order:
      return plane ? 1.727 : 2.143;
  }
  return 1;
}

}  // namespace

double fastest_wave(const Case& a_case) {
  double fastest = 0;
  for (const BodyCase& body : a_case.bodies) {
    fastest = std::max(fastest, kernels::wave_speed_at_rest(body.material));
  }
  return fastest / std::sqrt(a_case.total_lagrangian.mass_scaling);
}

double stable_cfl(const Case& a_case) {
  if (a_case.method == "total_lagrangian" || a_case.method == "point_based") return 1;
  const auto& discretisation = a_case.discretisation;
  const double waves =
      on_imaginary_axis / largest_response(discretisation.kernel, a_case.dimension);
  // delta^4 is at most 16 along each direction, and 16 is what kappa has in its denominator.
  const double dissipation =
      std::max(discretisation.dissipation.velocity, discretisation.dissipation.stress) *
      a_case.dimension;
  return near_surfaces * (dissipation > 0 ? std::min(waves, on_real_axis / dissipation) : waves);
}

double cfl_number(const Case& a_case) {
  const bool long_steps = a_case.method == "remeshed" && a_case.contacts.empty();
  return a_case.time.cfl.value_or(std::min(long_steps ? 1 : 0.5, stable_cfl(a_case)));
}

std::optional<double> stable_step(const Case& a_case, double wave_speed) {
  const bool has_limit =
      a_case.method == "remeshed" || a_case.method == "sph" ||
      (a_case.method == "total_lagrangian" && !a_case.total_lagrangian.match_time_step);
  if (!has_limit) return std::nullopt;
  const double present = wave_speed / std::sqrt(a_case.total_lagrangian.mass_scaling);
  return stable_cfl(a_case) * a_case.discretisation.spacing /
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
