// plane PROBLEM total|updated FINENESS [THREADS]
//
// The plane problems of bench/accuracy.toml with one of the two methods of SPHinXsys. Walls and
// clamps are three layers of particles, more than the kernels reach. FINENESS is the number of
// particles across the block or the plate, or across a square with the area of the disc.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "bench/peers/sphinxsys/problem.hpp"

namespace {

using peers::Problem;
using SPH::Real;
using SPH::Vecd;
using Values = std::vector<std::pair<std::string, Real>>;

constexpr int wall_layers = 3;

int run(const Problem& problem, bool is_updated, const peers::Observe& observe) {
  return is_updated ? peers::run_updated_lagrangian(problem, observe)
                    : peers::run_total_lagrangian(problem, observe);
}

/// Where the line through the outer particle and the next one in its row of the lattice leaves the
/// body, half a spacing beyond the outer one.
Vecd surface(const Vecd& outer, const Vecd& next) { return 1.5 * outer - 0.5 * next; }

/// A block that two pistons compress to half its height.
void compression(Problem problem, int across, bool is_updated) {
  constexpr Real c10 = 2.2, compressibility = 0.001, end = 0.02;  // [Pa], [1/Pa], [s]
  const Real shear = 2 * c10, bulk = 2 / compressibility;
  problem.youngs_modulus = 9 * bulk * shear / (3 * bulk + shear);
  problem.poissons_ratio = (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear);
  problem.is_neo_hookean = true;
  problem.spacing = 1.0 / across;
  problem.stops = {end};
  for (int j = -wall_layers; j < 2 * across + wall_layers; ++j)
    for (int i = 0; i < across; ++i) {
      const Vecd place((i + 0.5) * problem.spacing - 0.5, (j + 0.5) * problem.spacing - 1);
      const bool is_held = j < 0 || j >= 2 * across;
      problem.add(place, Vecd(0, -25 * std::clamp(place.y(), -1.0, 1.0)), is_held);
    }
  Real flank = 0, mid_height = 0;
  const auto measure = [&](Real time, const Vecd* position, SPH::BaseParticles&) {
    if (time < end) return;
    for (int j = wall_layers; j < 2 * across + wall_layers; ++j) {
      const Vecd* row = position + j * across;
      const Vecd right = surface(row[across - 1], row[across - 2]), left = surface(row[0], row[1]);
      for (const Vecd& place : {right, Vecd(-left)}) {
        if (std::abs(place.y()) < 0.3) flank = std::max(flank, place.x() - 0.5);
        if (std::abs(place.y()) < 0.07) mid_height = std::max(mid_height, place.x() - 0.5);
      }
    }
  };
  const int steps = run(problem, is_updated, measure);
  peers::print_result(2 * across * across, steps, {{"flank", flank}, {"mid_height", mid_height}});
}

/// The radius of the surface: the radial stretch a + b R^2 at R = 1, fitted to all particles.
Real radius(const Problem& problem, const Vecd* position) {
  Real r2 = 0, r4 = 0, r6 = 0, first = 0, third = 0;
  for (std::size_t p = 0; p < problem.position.size(); ++p) {
    const Real square = problem.position[p].squaredNorm();
    const Real product = problem.position[p].norm() * position[p].norm();
    r2 += square;
    r4 += square * square;
    r6 += square * square * square;
    first += product;
    third += product * square;
  }
  return (first * (r6 - r4) + third * (r2 - r4)) / (r2 * r6 - r4 * r4);
}

Real angular_momentum(const Vecd* position, const Vecd* velocity, const Real* mass, std::size_t n) {
  Real sum = 0;
  for (std::size_t p = 0; p < n; ++p)
    sum += mass[p] * (position[p].x() * velocity[p].y() - position[p].y() * velocity[p].x());
  return sum;
}

/// Two revolutions of a free disc.
void rotating_cylinder(Problem problem, int across, bool is_updated) {
  problem.youngs_modulus = 100;
  problem.poissons_ratio = 0.3;
  problem.spacing = std::sqrt(SPH::Pi) / across;
  problem.stops = {0.5, 2};
  const int cells = across / 2 + 1;
  for (int j = -cells; j < cells; ++j)
    for (int i = -cells; i < cells; ++i) {
      const Vecd place((i + 0.5) * problem.spacing, (j + 0.5) * problem.spacing);
      const Vecd motion(-2 * SPH::Pi * place.y(), 2 * SPH::Pi * place.x());
      if (place.norm() < 1) problem.add(place, motion, false);
    }
  Real initial = 0, momentum = 0, radius_then = 0;
  const auto measure = [&](Real time, const Vecd* position, SPH::BaseParticles& particles) {
    if (time == problem.stops[0]) radius_then = radius(problem, position);
    if (time > 0 && time < problem.stops[1]) return;
    momentum =
        angular_momentum(position, particles.getVariableDataByName<Vecd>("Velocity"),
                         particles.getVariableDataByName<Real>("Mass"), problem.position.size());
    if (time == 0) initial = momentum;
  };
  const int steps = run(problem, is_updated, measure);
  peers::print_result(
      problem.position.size(), steps,
      {{"angular_momentum", momentum / initial}, {"radius_after_half_a_turn", radius_then}});
}

/// Times at which a value changes its sign, by linear interpolation.
class Crossings {
 public:
  void add(Real time, Real value) {
    if (last_value_ * value < 0)
      times_.push_back(last_time_ + (time - last_time_) * last_value_ / (last_value_ - value));
    last_time_ = time;
    last_value_ = value;
  }
  /// Twice the mean time between crossings.
  Real period() const {
    if (times_.size() < 2) return std::nan("");
    return 2 * (times_.back() - times_.front()) / static_cast<Real>(times_.size() - 1);
  }

 private:
  std::vector<Real> times_ = {};
  Real last_time_ = 0, last_value_ = 0;
};

/// A clamped plate that oscillates in its first mode.
void oscillating_plate(Problem problem, int across, bool is_updated) {
  constexpr Real k = 1.8751041, thickness = 0.1;  // [1/m], [m]
  problem.youngs_modulus = 100;
  problem.poissons_ratio = 0.3;
  problem.spacing = thickness / across;
  problem.stops = {13};
  const int along = 10 * across;
  for (int i = -wall_layers; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const Real x = (i + 0.5) * problem.spacing, y = (j + 0.5) * problem.spacing - thickness / 2;
      const Real mode = 3.0377857 * (std::cosh(k * x) - std::cos(k * x)) -
                        2.2300249 * (std::sinh(k * x) - std::sin(k * x));
      problem.add(Vecd(x, y), Vecd(0, i < 0 ? 0 : 0.00751263 * mode), i < 0);
    }
  Crossings crossings;
  const auto measure = [&](Real time, const Vecd* position, SPH::BaseParticles&) {
    const Vecd* last = position + (along - 1 + wall_layers) * across;
    const int lower = (across - 1) / 2, upper = across / 2;
    const Vecd tip = 0.5 * (surface(last[lower], last[lower - across]) +
                            surface(last[upper], last[upper - across]));
    crossings.add(time, tip.y());
  };
  const int steps = run(problem, is_updated, measure);
  peers::print_result(along * across, steps, {{"flexural_period", crossings.period()}});
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments, arguments + count);
  Problem problem;
  if (count > 4) problem.threads = std::atoi(arguments[4]);
  const auto solve = count < 4                         ? nullptr
                     : words[1] == "compression"       ? compression
                     : words[1] == "rotating_cylinder" ? rotating_cylinder
                     : words[1] == "oscillating_plate" ? oscillating_plate
                                                       : nullptr;
  if (solve == nullptr) {
    std::cerr << "plane compression|rotating_cylinder|oscillating_plate total|updated FINENESS "
                 "[THREADS]\n";
    return 2;
  }
  solve(problem, std::atoi(arguments[3]), words[2] == "updated");
}
