#include "engine/simulation/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/method/step_failure.hpp"

namespace pliant {

namespace {

constexpr std::int64_t interval = 256;  // steps between two looks: they cost a few steps each
constexpr double tolerated = 0.05;      // of the largest energy or work, of the mass, of momentum
constexpr double credible = 0.5;        // of the largest energy or work: it has doubled by itself

double largest_of(const EnergyBudget& budget, double energy) {
  return std::max({energy, std::abs(budget.wall_work), std::abs(budget.load_work),
                   std::abs(budget.body_force_work), std::abs(budget.cut_work)});
}

}  // namespace

ConservedQuantities conserved(const BodyIntegrals& sum) {
  return {sum.mass,           sum.momentum,      sum.angular_momentum,
          sum.kinetic_energy, sum.strain_energy, sum.kinetic_energy + sum.strain_energy};
}

void Watch::begin(Solver& solver) {
  start_ = conserved(solver.integrals());
  look(solver);
}

// A change is seen against the largest value so far: what a body had, or what was done to it.
void Watch::look(Solver& solver) {
  const double t = solver.clock().time;
  present_ = conserved(solver.integrals());
  const auto keep = [t](Excess& excess, double share) {
    if (share > excess.share) excess = {share, t, excess.warned};
  };
  if (const auto budget = solver.energy_budget()) {
    is_known_ = 1;
    budget_ = *budget;
    created_ = present_.total_energy - start_.total_energy - budget_.work() + budget_.damping;
    scale_ = std::max(scale_, largest_of(budget_, present_.total_energy));
    if (scale_ > 0) keep(energy_, created_ / scale_);
  }
  keep(mass_, std::abs(present_.mass / start_.mass - 1));
  if (!solver.bodies_are_free()) return;
  momentum_scale_ =
      std::max(momentum_scale_, std::sqrt(2 * present_.mass * present_.kinetic_energy));
  double square = 0;
  for (int a = 0; a < 3; ++a) square += std::pow(present_.momentum[a] - start_.momentum[a], 2);
  if (momentum_scale_ > 0) keep(momentum_, std::sqrt(square) / momentum_scale_);
}

std::string Watch::judge(Excess Watch::*of, CheckResponse response, const Solver& solver,
                         const std::string& what, const std::string& remedy) {
  Excess& excess = this->*of;
  if (response == CheckResponse::off || !(excess.share > tolerated)) return "";
  const bool is_over = of == &Watch::energy_ && excess.share > credible;
  if (response == CheckResponse::stop || is_over) {
    throw failed_step(settings_, solver.clock(), what, {remedy});
  }
  // Again only when it has become twice as bad.
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
            "use a smaller time step or a finer spacing (or set checks.energy)"),
      judge(&Watch::mass_, checks.mass, solver,
            fmt::format("the mass has changed by a share of {:.3g}", mass_.share),
            "use a finer spacing, or remesh less often (or set checks.mass)"),
      judge(&Watch::momentum_, checks.momentum, solver,
            fmt::format("the momentum has changed by a share of {:.3g}, though nothing acts on "
                        "the bodies",
                        momentum_.share),
            "use a finer spacing (or set checks.momentum)")};
  std::string text;
  for (const std::string& warning : warnings) {
    if (!warning.empty()) text += (text.empty() ? "" : "\n") + warning;
  }
  return text;
}

SummaryChecks Watch::report() const {
  SummaryChecks checks;
  checks.energy_is_known = is_known_ != 0;
  checks.wall_work = budget_.wall_work;
  checks.load_work = budget_.load_work;
  checks.body_force_work = budget_.body_force_work;
  checks.cut_work = budget_.cut_work;
  checks.damping = budget_.damping;
  checks.created = created_;
  checks.largest_energy = scale_;
  checks.energy = {energy_.share, energy_.time};
  checks.mass = {mass_.share, mass_.time};
  checks.momentum = {momentum_.share, momentum_.time};
  return checks;
}

std::array<double*, 21> Watch::numbers() {
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
          &momentum_.warned};
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
