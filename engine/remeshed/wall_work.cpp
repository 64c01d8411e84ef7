#include "engine/remeshed/wall_work.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/ghosts/fit_evaluator.hpp"
#include "kernels/remeshed/ghosts/wall_friction.hpp"

namespace pliant::remeshed {

namespace {

// What a ghost stands for of the part of the wall that the body covers, (RP.65).
template <class T, int D>
double area_on_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g) {
  const double h = body.lattice.spacing;
  const std::int64_t slot = ghosts.slot[g];
  const Point<D> x = body.lattice.node(body.population.layout.cell(slot));
  double depth = 0;
  for (int a = 0; a < D; ++a) depth -= (x[a] - ghosts.foot[g][a]) * ghosts.normal[g][a];
  const double layer = std::max(0., 1 - std::abs(depth / h - 1));
  const double covered = std::clamp(0.5 - body.stage[0].get(Field::level_set)[slot] / h, 0., 1.);
  return std::pow(h, D - 1) * layer * covered;
}

// Whether another wall lies before a foot point: the body ends there.
template <int D>
bool is_covered(const Boundaries<D>& boundaries, int wall, const Point<D>& foot) {
  for (int w = 0; w < static_cast<int>(boundaries.walls.size()); ++w) {
    const Wall<D>& other = boundaries.walls[w];
    if (w != wall && other.is_attached() && other.distance(foot) < 0) return true;
  }
  return false;
}

}  // namespace

template <class T, int D>
void add_wall_work(const Body<T, D>& body, int block, const Boundaries<D>& boundaries,
                   const BoundaryValues<D>& values, const std::vector<char>& watched,
                   double duration, const kernels::RemeshedTable<T, D>& kernels, Point<D>* impulse,
                   EnergyBudget& budget) {
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  const kernels::Impedance<T> impedance(body.material);
  FitEvaluator<T, D> fits(body, ghosts, kernels);
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    const int wall = ghosts.wall[g];
    if (wall < 0 || watched[wall] == 0 || is_covered<D>(boundaries, wall, ghosts.foot[g])) continue;
    const double area = area_on_wall(body, ghosts, g);
    if (area == 0) continue;
    const kernels::GhostFits<T, D> fit = fits.of(g);
    std::array<T, D> velocity, normal;
    for (int a = 0; a < D; ++a) {
      velocity[a] = static_cast<T>(values.wall_velocity[wall][a]);
      normal[a] = static_cast<T>(ghosts.normal[g][a]);
    }
    const auto push = kernels::wall_force_density<T, D>(
        fit, velocity, normal, static_cast<T>(boundaries.walls[wall].friction()), impedance);
    for (int a = 0; a < D; ++a) {
      const double given = duration * area * push[a];
      impulse[wall][a] += given;
      budget.wall_work += given * values.wall_velocity[wall][a];
    }
  }
}

template void add_wall_work<double, 2>(const Body<double, 2>&, int, const Boundaries<2>&,
                                       const BoundaryValues<2>&, const std::vector<char>&, double,
                                       const kernels::RemeshedTable<double, 2>&, Point<2>*,
                                       EnergyBudget&);
template void add_wall_work<double, 3>(const Body<double, 3>&, int, const Boundaries<3>&,
                                       const BoundaryValues<3>&, const std::vector<char>&, double,
                                       const kernels::RemeshedTable<double, 3>&, Point<3>*,
                                       EnergyBudget&);
template void add_wall_work<float, 2>(const Body<float, 2>&, int, const Boundaries<2>&,
                                      const BoundaryValues<2>&, const std::vector<char>&, double,
                                      const kernels::RemeshedTable<float, 2>&, Point<2>*,
                                      EnergyBudget&);
template void add_wall_work<float, 3>(const Body<float, 3>&, int, const Boundaries<3>&,
                                      const BoundaryValues<3>&, const std::vector<char>&, double,
                                      const kernels::RemeshedTable<float, 3>&, Point<3>*,
                                      EnergyBudget&);

}  // namespace pliant::remeshed
