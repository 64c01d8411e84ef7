// beam FINENESS [THREADS]
//
// The cantilever of bench/accuracy.toml with the total Lagrangian method of SPHinXsys, with
// FINENESS particles across the beam. The clamp is three layers of particles. The last two layers
// get 3/2 and -1/2 of the load, so that it acts at the end; the displacement of the tip is
// extrapolated to the end in the same way.
#include <cstdlib>
#include <iostream>

#include "bench/peers/sphinxsys/problem.hpp"

int main(int count, char** arguments) {
  if (count < 2) {
    std::cerr << "beam FINENESS [THREADS]\n";
    return 2;
  }
  using SPH::Vecd;
  constexpr int wall_layers = 3;
  const int across = std::atoi(arguments[1]), along = 5 * across;
  peers::Problem problem;
  if (count > 2) problem.threads = std::atoi(arguments[2]);
  problem.density = 1000;
  problem.youngs_modulus = 1e5;
  problem.poissons_ratio = 0.3;
  problem.spacing = 2.0 / across;
  problem.damping = 0.4;
  problem.load_time = 20;
  problem.stops = {80};
  for (int i = -wall_layers; i < along; ++i)
    for (int j = 0; j < across; ++j)
      for (int k = 0; k < across; ++k) {
        const Vecd corner(0, -1, -1), cell(i + 0.5, j + 0.5, k + 0.5);
        const double share = i == along - 1 ? 1.5 : i == along - 2 ? -0.5 : 0;
        problem.add(corner + problem.spacing * cell, Vecd::Zero(), i < 0);
        problem.load.emplace_back(0, 0, -share / (across * across));
      }
  double tip = 0;
  const auto measure = [&](double time, const Vecd* position, SPH::BaseParticles&) {
    if (time < problem.stops.back()) return;
    const int section = across * across;
    const Vecd* last = position + (along - 1 + wall_layers) * section;
    for (const int j : {(across - 1) / 2, across / 2})
      for (const int k : {(across - 1) / 2, across / 2}) {
        const Vecd* outer = last + j * across + k;
        const double place = -1 + problem.spacing * (k + 0.5);
        tip += (1.5 * outer->z() - 0.5 * (outer - section)->z() - place) / 4;
      }
  };
  const int steps = peers::run_total_lagrangian(problem, measure);
  peers::print_result(static_cast<std::size_t>(along) * across * across, steps,
                      {{"tip_displacement", tip}});
}
