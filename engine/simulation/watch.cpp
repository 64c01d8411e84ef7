#include "engine/simulation/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/case/checks/stability.hpp"
#include "engine/case/method_rules.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/step_failure.hpp"

namespace pliant {

namespace {

constexpr std::int64_t interval =
    256;  // steps between checks, each of which costs as much as a few steps
constexpr double tolerated = 0.05;  // share of the largest energy or work, of the mass, of momentum
constexpr double credible =
    1;  // share of the largest energy or work: the energy has doubled spuriously
constexpr double tolerated_turn = 0.015;  // share of the angular momentum

double largest_of(const EnergyBudget& budget, double energy) {
  return std::max({energy, std::abs(budget.wall_work), std::abs(budget.load_work),
                   std::abs(budget.body_force_work), std::abs(budget.cut_work),
                   std::abs(budget.blade_work)});
}

/// The place of all bodies at t = 0: the centre of their bounding box, and the radius of gyration
/// of the box as a solid of uniform density.
struct Middle {
  Vector centre = {};
  double radius = 0;
};

Middle middle_of(const Case& settings) {
  Box<3> all = bounding_box(settings.bodies.front().geometry);
  for (const BodyCase& body : settings.bodies) {
    const Box<3> box = bounding_box(body.geometry);
    for (int a = 0; a < settings.dimension; ++a) {
      all.lower[a] = std::min(all.lower[a], box.lower[a]);
      all.upper[a] = std::max(all.upper[a], box.upper[a]);
    }
  }
  Middle middle;
  double square = 0;
  for (int a = 0; a < settings.dimension; ++a) {
    middle.centre[a] = (all.lower[a] + all.upper[a]) / 2;
    square += std::pow((all.upper[a] - all.lower[a]) / 2, 2) / 3;
  }
  middle.radius = std::sqrt(square);
  return middle;
}

/// A strain that rounding errors alone can cause.
double rounding_strain(const Case& settings) {
  constexpr double steps_of_rounding = 100;
  return steps_of_rounding * (settings.precision == Precision::binary32
                                  ? std::numeric_limits<float>::epsilon()
                                  : std::numeric_limits<double>::epsilon());
}

/// If plain SPH does not conserve energy, another method is one more remedy.
std::string better_than_sph(const Case& settings) {
  return settings.method == "sph" ? ", or method = \"remeshed\"" : "";
}

/// Where the surface of one remeshed body ends on another, their contact creates energy as long as
/// they push each other.
std::string remedy_for_created_energy(const Case& settings) {
  const bool meets_remeshed =
      !settings.contacts.empty() && settings.rules != nullptr && settings.rules->remeshes;
  return fmt::format(
      "use a smaller time step or a finer spacing{}{} (or set checks.energy)",
      better_than_sph(settings),
      meets_remeshed ? ", or method = \"total_lagrangian\" where bodies stay in contact" : "");
}

bool is_periodic(const Case& settings) {
  const auto& axis = settings.periodic.axis;
  return std::any_of(axis.begin(), axis.end(), [](bool periodic) { return periodic; });
}

}  // namespace

ConservedQuantities conserved(const BodyIntegrals& sum) {
  return {sum.mass,           sum.momentum,      sum.angular_momentum,
          sum.kinetic_energy, sum.strain_energy, sum.kinetic_energy + sum.strain_energy};
}

void Watch::begin(Solver& solver) {
  start_ = conserved(solver.balance().integrals);
  look(solver);
}

// The strain energy is a difference of terms of the size of the moduli, such as F:F - 3 and ln J.
// Strains below the square root of their rounding error are lost in it.
double Watch::rounding_energy() const {
  constexpr double of_differences = 4 * std::numeric_limits<double>::epsilon();
  const double share = std::max(std::pow(rounding_strain(settings_), 2), of_differences);
  return start_.mass * mass_scaling_ * share * std::pow(fastest_wave(settings_), 2);
}

// The reference is the largest energy or work so far, without the energy that was created.
void Watch::look(Solver& solver) {
  const double t = solver.clock().time;
  const Balance balance = solver.balance();
  present_ = conserved(balance.integrals);
  const auto keep = [t](Excess& excess, double share) {
    if (share > excess.share) excess = {share, t, excess.warned};
  };
  if (balance.budget) {
    is_known_ = 1;
    budget_ = *balance.budget;
    created_ = present_.total_energy - start_.total_energy - budget_.work() + budget_.losses();
    // Under an initial stress the strain energy becomes negative where a body springs back.
    const double energy = std::max(present_.total_energy, present_.kinetic_energy);
    scale_ = std::max(scale_, largest_of(budget_, energy - std::max(created_, 0.)));
    if (scale_ > rounding_energy()) keep(energy_, created_ / scale_);
  }
  keep(mass_, std::abs(present_.mass / start_.mass - 1));
  if (solver.bodies_are_free()) look_at_momentum(solver);
}

// The angular momentum is about the centre of the bodies at the start. A periodic cell does not
// conserve it.
void Watch::look_at_momentum(const Solver& solver) {
  const double t = solver.clock().time;
  const double speed_and_mass =
      std::sqrt(2 * mass_scaling_ * present_.mass * present_.kinetic_energy);
  const auto keep = [t](Excess& excess, double& scale, double present, const Vector& change) {
    scale = std::max(scale, present);
    const double share = scale > 0 ? std::hypot(change[0], change[1], change[2]) / scale : 0;
    if (share > excess.share) excess = {share, t, excess.warned};
  };
  Vector linear = {}, angular = {};
  for (int a = 0; a < 3; ++a) linear[a] = present_.momentum[a] - start_.momentum[a];
  keep(momentum_, momentum_scale_, speed_and_mass, linear);
  if (is_periodic(settings_)) return;
  const Middle middle = middle_of(solver.settings());
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    angular[a] = present_.angular_momentum[a] - start_.angular_momentum[a] -
                 (middle.centre[b] * linear[c] - middle.centre[c] * linear[b]);
  }
  keep(angular_momentum_, angular_scale_, middle.radius * speed_and_mass, angular);
}

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

std::string Watch::observe(Solver& solver, bool last) {
  const auto& checks = settings_.checks;
  const bool is_off = checks.energy == CheckResponse::off && checks.mass == CheckResponse::off &&
                      checks.momentum == CheckResponse::off;
  if (!last && (is_off || solver.clock().step % interval != 0)) return "";
  look(solver);
  const std::vector<std::string> warnings = {
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
      last && checks.energy != CheckResponse::off ? judge_loss() : ""};
  std::string text;
  for (const std::string& warning : warnings) {
    if (!warning.empty()) text += (text.empty() ? "" : "\n") + warning;
  }
  return text;
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
      "matters{} (or set checks.energy)",
      -created_ / scale_, better_than_sph(settings_));
}

SummaryChecks Watch::report() const {
  SummaryChecks checks;
  checks.energy_is_known = is_known_ != 0;
  checks.wall_work = budget_.wall_work;
  checks.load_work = budget_.load_work;
  checks.body_force_work = budget_.body_force_work;
  checks.cut_work = budget_.cut_work;
  checks.blade_work = budget_.blade_work;
  checks.damping = budget_.damping;
  checks.friction = budget_.friction;
  checks.created = created_;
  checks.largest_energy = scale_;
  checks.energy = {energy_.share, energy_.time};
  checks.mass = {mass_.share, mass_.time};
  checks.momentum = {momentum_.share, momentum_.time};
  checks.angular_momentum = {angular_momentum_.share, angular_momentum_.time};
  return checks;
}

std::array<double*, 25> Watch::numbers() {
  return {&start_.mass,
          &start_.momentum[0],
          &start_.momentum[1],
          &start_.momentum[2],
          &start_.angular_momentum[0],
          &start_.angular_momentum[1],
          &start_.angular_momentum[2],
          &start_.kinetic_energy,
          &start_.strain_energy,
          &start_.total_energy,
          &scale_,
          &momentum_scale_,
          &energy_.share,
          &energy_.time,
          &energy_.warned,
          &mass_.share,
          &mass_.time,
          &mass_.warned,
          &momentum_.share,
          &momentum_.time,
          &momentum_.warned,
          &angular_scale_,
          &angular_momentum_.share,
          &angular_momentum_.time,
          &angular_momentum_.warned};
}

void Watch::put(ArchiveWriter& archive) const {
  Watch copy = *this;
  std::vector<double> values;
  for (const double* number : copy.numbers()) values.push_back(*number);
  archive.put("watch", std::span<const double>(values));
}

void Watch::get(const ArchiveReader& archive) {
  const auto values = archive.get<double>("watch");
  const auto places = numbers();
  for (std::size_t i = 0; i < places.size(); ++i) *places[i] = values.at(i);
}

}  // namespace pliant
