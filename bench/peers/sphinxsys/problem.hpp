#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <base_body.hpp>
#include <base_particles.hpp>

namespace peers {

using SPH::Matd;
using SPH::Real;
using SPH::Vecd;

/// A body of particles on a lattice, with its material, constraints and loads. SI units.
struct Problem {
  Real spacing = 0;
  std::vector<Vecd> position = {}, velocity = {};  ///< at the start
  std::vector<bool> held = {};  ///< keeps its velocity, like a particle of a wall
  std::vector<Vecd> load = {};  ///< force on each particle at `load_time`; may be empty
  Real load_time = 1;           ///< the load grows linearly until then
  Real damping = 0;             ///< [1/s] force -damping m v
  Real density = 1, youngs_modulus = 0, poissons_ratio = 0;
  bool is_neo_hookean = false;   ///< neo-Hookean with p = K (1 - J); else linear laws
  std::vector<Real> stops = {};  ///< times at which a step ends; the last one is the end
  int threads = 2;

  void add(const Vecd& place, const Vecd& motion, bool is_held);
};

/// Called at the start and after each step.
using Observe = std::function<void(Real time, const Vecd* position, SPH::BaseParticles& particles)>;

/// Advances to the end with the total Lagrangian method, in the same order and with the same steps
/// and dissipation as the examples oscillating_beam and passive_cantilever of SPHinXsys. Returns
/// the number of steps.
int run_total_lagrangian(const Problem& problem, const Observe& observe);

/// The same with the updated Lagrangian method, as in the example oscillating_beam_UL, in plane
/// strain.
int run_updated_lagrangian(const Problem& problem, const Observe& observe);

/// Prints a line of JSON for run.py.
void print_result(std::size_t particles, int steps,
                  const std::vector<std::pair<std::string, Real>>& values);

}  // namespace peers
