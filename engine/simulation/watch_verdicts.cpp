#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/checks/stability.hpp"
#include "engine/case/method_rules.hpp"
#include "engine/case/placement.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/simulation/watch.hpp"

namespace pliant {

namespace {

constexpr double tolerated = 0.05;  // share of the largest energy or work, of the mass, of momentum
constexpr double credible =
    1;  // share of the largest energy or work: the energy has doubled spuriously
constexpr double tolerated_turn = 0.015;  // share of the angular momentum

/// If plain SPH does not conserve energy, another method is one more remedy.
std::string better_than_sph(const Case& settings) {
  return settings.method == "sph" ? ", or method = \"remeshed\"" : "";
}

/// The least (mu/rho)^(1/2) of the bodies [m/s].
double slowest_shear_wave(const Case& settings) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const BodyCase& body : settings.bodies) {
    slowest = std::min(slowest, std::sqrt(body.material.shear_modulus / body.material.density));
  }
  return slowest;
}

/// Where the surface of one remeshed body ends on another, their contact creates energy as long as
/// they push each other. Cells of the total Lagrangian method may invert under a wall that is
/// pressed in deeper than its radius.
std::string better_in_contact(const Case& settings) {
  if (is_remeshed(settings) && !settings.contacts.empty()) {
    return ", or method = \"total_lagrangian\" where bodies stay in contact";
  }
  const bool has_tools = has_boundary(settings, BoundaryCase::Kind::contact_wall);
  if (settings.method == "total_lagrangian" && has_tools) {
    return ", or a stiff body with a [[contact]] in place of a wall that is pressed in deep";
  }
  return "";
}

/// Surfaces of remeshed bodies that swing between remeshings feed waves, more so if they lie at an
/// angle to the lattice.
std::string better_if_held(const Case& settings) {
  return is_remeshed(settings) && has_no_slip_walls(settings)
             ? ", or method = \"total_lagrangian\" for bodies that walls hold"
             : "";
}

std::string remedy_for_created_energy(const Case& settings) {
  return fmt::format("use a smaller time step or a finer spacing{}{}{} (or set checks.energy)",
                     better_than_sph(settings), better_in_contact(settings),
                     better_if_held(settings));
}

}  // namespace

std::string Watch::judge(Excess Watch::*of, CheckResponse response, const Solver& solver,
                         const std::string& what, const std::string& remedy) {
  Excess& excess = this->*of;
  const double bar = of == &Watch::angular_momentum_ ? tolerated_turn : tolerated;
  if (response == CheckResponse::off || !(excess.share > bar)) return "";
  const bool is_over = of == &Watch::energy_ && excess.share > credible;
  if (response == CheckResponse::stop || is_over) {
    throw failed_step(settings_, solver.clock(), what, {remedy});
  }
  // Warns again only when the excess has doubled.
  if (excess.share < 2 * excess.warned) return "";
  excess.warned = excess.share;
  return fmt::format("warning: t = {:.6g} s: {}; {}", solver.clock().time, what, remedy);
}

std::vector<std::string> Watch::verdicts(const Solver& solver, bool last) {
  const auto& checks = settings_.checks;
  const bool judges_the_end = last && checks.energy != CheckResponse::off;
  std::vector<std::string> warnings = {
      judge(&Watch::energy_, checks.energy, solver,
            fmt::format("energy was created without work: {:.3g} of the largest energy or work so "
                        "far",
                        energy_.share),
            remedy_for_created_energy(settings_)),
      judge(&Watch::mass_, checks.mass, solver,
            fmt::format("the mass has changed by a share of {:.3g}", mass_.share),
            "use a finer spacing, or remesh less often (or set checks.mass)"),
      judge(&Watch::momentum_, checks.momentum, solver,
            fmt::format("the momentum has changed by a share of {:.3g}, though nothing acts on "
                        "the bodies",
                        momentum_.share),
            "use a finer spacing (or set checks.momentum)"),
      judge(&Watch::angular_momentum_, checks.momentum, solver,
            fmt::format("the angular momentum has changed by a share of {:.3g}, though nothing "
                        "acts on the bodies",
                        angular_momentum_.share),
            "use a finer spacing (or set checks.momentum)"),
      judge_number(solver, last),
      judge_rest(solver, last),
      judges_the_end ? judge_loss() : "",
      judges_the_end ? judge_slow_load(solver) : "",
      judges_the_end ? judge_linear_law() : "",
      judges_the_end ? judge_damping(solver) : "",
      judges_the_end ? judge_precision() : ""};
  std::erase(warnings, "");
  return warnings;
}

// Comparisons with NaN are false, so no other check would detect an energy that is not a number.
std::string Watch::judge_number(const Solver& solver, bool last) const {
  const CheckResponse response = settings_.checks.energy;
  if (response == CheckResponse::off || std::isfinite(present_.total_energy)) return "";
  const std::string what = "the energy of the bodies is not a number",
                    remedy = "use a finer spacing or a smaller load (or set checks.energy)";
  if (response == CheckResponse::stop) throw failed_step(settings_, solver.clock(), what, {remedy});
  return last ? fmt::format("warning: in the end {}; {}", what, remedy) : "";
}

// If bodies had no energy and received none, there is no reference. Strains below the noticed one
// do not affect other results.
std::string Watch::judge_rest(const Solver& solver, bool last) const {
  constexpr double noticed_strain = 1e-4;
  const CheckResponse response = settings_.checks.energy;
  const double noticed =
      start_.mass * mass_scaling_ * std::pow(noticed_strain * fastest_wave(settings_), 2);
  if (!last || response == CheckResponse::off || is_known_ == 0 || scale_ > rounding_energy() ||
      !(created_ > noticed)) {
    return "";
  }
  const std::string what = fmt::format("bodies at rest got an energy of {:.3g} J by themselves",
                                       created_),
                    remedy = "let them stand apart at the start (or set checks.energy)";
  if (response == CheckResponse::stop) throw failed_step(settings_, solver.clock(), what, {remedy});
  return fmt::format("warning: in the end {}; {}", what, remedy);
}

// Only at the end: energy that a body seems to lose while contact flattens it comes back. The
// losses of viscous bodies are physical.
std::string Watch::judge_loss() const {
  const bool is_viscous = std::any_of(
      settings_.bodies.begin(), settings_.bodies.end(),
      [](const BodyCase& body) { return !body.prony.empty() || !body.prony_shear.empty(); });
  if (is_viscous || !(scale_ > rounding_energy()) || !(-created_ > tolerated * scale_)) return "";
  return fmt::format(
      "warning: in the end {:.3g} of the largest energy or work is lost without damping, to "
      "numerical dissipation, contact and remeshing; use a finer spacing where the motion "
      "matters{}{} (or set checks.energy)",
      -created_ / scale_, better_than_sph(settings_),
      is_remeshed(settings_) ? ", or method = \"total_lagrangian\"" : "");
}

// Of an incompressible body in tension, the strain energy is 3/2 mu times the square of the strain.
double Watch::strain_of(double energy) const {
  return std::sqrt(energy / (1.5 * present_.mass)) / slowest_shear_wave(settings_);
}

double Watch::strain() const { return strain_of(present_.strain_energy); }

std::string Watch::judge_slow_load(const Solver& solver) const {
  constexpr double large_strain = 0.1;
  constexpr double slow = 30;  // passages of a wave through the radius of gyration
  const double passages = solver.clock().time * fastest_wave(settings_) / middle_.radius;
  if (!is_remeshed(settings_) || settings_.boundaries.empty() || !(passages > slow)) return "";
  if (!(strain() > large_strain)) return "";
  return fmt::format(
      "warning: a strain of about {:.2g} lasts in the end, under loads that are slow compared with "
      "the waves in the bodies; the remeshed method creeps then, and its forces may be wrong by "
      "10 % or more; take method = \"total_lagrangian\" (or set checks.energy)",
      strain());
}

// (TL.3) and (PB.6) agree with the rate form to first order. Measured for blocks that are squeezed
// to 0.7 and pulled to 1.4 of their length, with Poisson's ratios of 0.3 and 0.45.
std::string Watch::judge_linear_law() const {
  constexpr double large_strain = 0.08, deviation = 0.6;  // the latter per strain
  const bool is_linear = std::ranges::any_of(settings_.bodies, [](const BodyCase& body) {
    return !kernels::carries_deformation(body.material.model);
  });
  const bool has_rate_form = is_remeshed(settings_) || settings_.method == "sph";
  if (!is_linear || has_rate_form || !(strain() > large_strain)) return "";
  return fmt::format(
      "warning: a strain of about {:.2g} lasts in the end; in this method linear materials are "
      "neo-Hookean, and deviate from Hooke's law in rate form by up to {:.0f} % then; name the "
      "model that you mean, or take method = \"remeshed\" (or set checks.energy)",
      strain(), 100 * deviation * strain());
}

// Adaptive damping is to bring bodies to rest. While they move, walls and loads work against it.
// The power is the square of how far the bodies are from rest, which the forces show. Measured for
// beams, blocks in shear and blocks under loads: the forces are as far off as this share, those
// that bend up to five times as far.
std::string Watch::judge_damping(const Solver& solver) const {
  const StepClock& clock = solver.clock();
  const bool is_to_rest = is_damped_adaptively(settings_) && is_known_ != 0;
  if (!is_to_rest || !(scale_ > rounding_energy())) return "";
  const double at_end = 2 * clock.damping * present_.kinetic_energy;
  const double power = std::max(0.0, std::min(at_end, damping_power_));
  const double share = std::sqrt(power * clock.time / scale_);
  if (!(share > tolerated)) return "";
  return fmt::format(
      "warning: in the end the bodies still move, and damping takes a share of {:.2g} of the "
      "forces on them; hold the load until they are at rest (time.end), or load more slowly (or "
      "set checks.energy)",
      share);
}

// Measured for cantilevers in 2D and 3D under weights of which the least strains them by 1e-6.
std::string Watch::judge_precision() const {
  if (settings_.precision != Precision::binary32 || settings_.method == "sph") return "";
  const bool is_to_rest = is_damped_adaptively(settings_);
  const double least = is_remeshed(settings_) ? 1e-3 : is_to_rest ? 5e-5 : 1e-6;
  const double most = strain_of(scale_);
  if (!(most > 0) || !(most < least)) return "";
  const std::string_view what = is_remeshed(settings_)
                                    ? "displacements may be several times too large"
                                : is_to_rest ? "adaptive damping may hold the bodies far from rest"
                                             : "displacements deviate by 1 % or more";
  return fmt::format(
      "warning: strains of about {:.1g} are too small for single precision: {}; take precision = "
      "\"double\" (or set checks.energy)",
      most, what);
}

}  // namespace pliant
