#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "engine/simulation/estimate.hpp"

// Estimates the wall time from a few steps of the case on a small lattice.
namespace pliant {

namespace {

constexpr double most_particles = 6000;
constexpr int warm_up = 2, most_steps = 60;
constexpr double enough_seconds = 0.3;

/// A factor for the spacing that leaves few particles and divides each period into whole cells; 0
/// if there is none.
int coarsening(const Case& a_case, double particles) {
  const double h = a_case.discretisation.spacing;
  const int least = std::max(
      1, static_cast<int>(std::ceil(std::pow(particles / most_particles, 1.0 / a_case.dimension))));
  const auto divides = [&](int factor) {
    for (int a = 0; a < a_case.dimension; ++a) {
      if (!a_case.periodic.axis[a]) continue;
      const long cells = std::lround((a_case.periodic.upper[a] - a_case.periodic.lower[a]) / h);
      if (cells % factor != 0) return false;
    }
    return true;
  };
  for (int factor = least; factor < 2 * least + 2; ++factor) {
    if (divides(factor)) return factor;
  }
  return 0;
}

double seconds_per_particle_step(Solver& solver) {
  for (int i = 0; i < warm_up; ++i) solver.step(HUGE_VAL);
  const double before = solver.step_seconds();
  double particle_steps = 0;
  for (int i = 0; i < most_steps && solver.step_seconds() - before < enough_seconds; ++i) {
    solver.step(HUGE_VAL);
    particle_steps += static_cast<double>(solver.particles());
  }
  return (solver.step_seconds() - before) / particle_steps;
}

}  // namespace

std::optional<double> estimated_seconds(const Case& a_case, const Estimate& size,
                                        const SolverOptions& options,
                                        const MethodRegistry& methods) {
  const auto particles = static_cast<double>(size.particles);
  const int factor = coarsening(a_case, particles);
  if (factor == 0) return std::nullopt;
  Case coarse = a_case;
  coarse.discretisation.spacing *= factor;
  try {
    const std::unique_ptr<Solver> solver = methods.make(coarse, options);
    const double seconds = seconds_per_particle_step(*solver);
    // Steps that the strain limits (time.strain) have the same length on any lattice.
    const double steps =
        std::max(static_cast<double>(size.steps), a_case.time.end / solver->time_step());
    return (steps + static_cast<double>(size.looks)) * particles * seconds;
  } catch (const std::exception&) {  // the coarse lattice cannot hold the case: no estimate
    return std::nullopt;
  }
}

}  // namespace pliant
