#include "engine/simulation/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/case/checks/stability.hpp"
#include "engine/case/placement.hpp"

namespace pliant {

namespace {

constexpr std::int64_t interval =
    256;  // steps between checks, each of which costs as much as a few steps

double largest_of(const EnergyBudget& budget, double energy) {
  return std::max({energy, std::abs(budget.wall_work), std::abs(budget.load_work),
                   std::abs(budget.body_force_work), std::abs(budget.cut_work),
                   std::abs(budget.blade_work)});
}

Watch::Middle middle_of(const Case& settings) {
  const Box<3> all = box_of_bodies(settings);
  Watch::Middle middle;
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

bool is_periodic(const Case& settings) {
  const auto& axis = settings.periodic.axis;
  return std::any_of(axis.begin(), axis.end(), [](bool periodic) { return periodic; });
}

}  // namespace

ConservedQuantities conserved(const BodyIntegrals& sum) {
  return {sum.mass,           sum.momentum,      sum.angular_momentum,
          sum.kinetic_energy, sum.strain_energy, sum.kinetic_energy + sum.strain_energy};
}

Watch::Watch(const Case& settings)
    : settings_(settings),
      mass_scaling_(step_limits(settings).mass_scaling),
      middle_(middle_of(settings)) {}

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
    if (t > looked_at_) damping_power_ = (budget_.damping - damped_by_then_) / (t - looked_at_);
    looked_at_ = t;
    damped_by_then_ = budget_.damping;
    created_ = present_.total_energy - start_.total_energy - budget_.work() + budget_.losses();
    // Under an initial stress the strain energy becomes negative where a body springs back. What it
    // has given up by then is an energy like any other, even if damping keeps the body slow.
    const double energy = std::max({present_.total_energy, present_.kinetic_energy,
                                    start_.total_energy - present_.total_energy});
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
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    angular[a] = present_.angular_momentum[a] - start_.angular_momentum[a] -
                 (middle_.centre[b] * linear[c] - middle_.centre[c] * linear[b]);
  }
  keep(angular_momentum_, angular_scale_, middle_.radius * speed_and_mass, angular);
}

std::string Watch::observe(Solver& solver, bool last) {
  const auto& checks = settings_.checks;
  const bool is_off = checks.energy == CheckResponse::off && checks.mass == CheckResponse::off &&
                      checks.momentum == CheckResponse::off;
  if (!last && (is_off || solver.clock().step % interval != 0)) return "";
  look(solver);
  return fmt::format("{}", fmt::join(verdicts(solver, last), "\n"));
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

std::array<double*, 27> Watch::numbers() {
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
          &angular_momentum_.warned,
          &looked_at_,
          &damped_by_then_};
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
