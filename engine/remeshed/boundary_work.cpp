#include "engine/remeshed/boundary_work.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/ghosts/fit_evaluator.hpp"
#include "kernels/remeshed/ghosts/wall_friction.hpp"

namespace pliant::remeshed {

namespace {

// The layer of slots at the distance k h of a surface, as in (RP.68).
double layer(double distance, int k) { return std::max(0., 1 - std::abs(distance - k)); }

/// The ghosts of one block, and what each of them stands for of the surface.
template <class T, int D>
class Shares {
 public:
  Shares(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts)
      : body_(body),
        ghosts_(ghosts),
        h_(body.lattice.spacing),
        phi_(body.stage[0].get(Field::level_set)) {}

  // (RP.65), of the part of the wall that the body covers.
  double of_wall(std::size_t g) const {
    const std::int64_t slot = ghosts_.slot[g];
    const Point<D> x = body_.lattice.node(body_.population.layout.cell(slot));
    double depth = 0;
    for (int a = 0; a < D; ++a) depth -= (x[a] - ghosts_.foot[g][a]) * ghosts_.normal[g][a];
    const double covered = std::clamp(0.5 - phi_[slot] / h_, 0., 1.);
    return std::pow(h_, D - 1) * layer(depth / h_, 1) * covered;
  }

  // (RP.68)
  double of_surface(std::size_t g) const {
    const double distance = phi_[ghosts_.slot[g]] / h_;
    const double l1 = layer(distance, 1), l2 = layer(distance, 2), l3 = layer(distance, 3);
    return std::pow(h_, D - 1) * (D == 2 ? 2 * l1 - l2 : 3 * l1 - 3 * l2 + l3);
  }

 private:
  const Body<T, D>& body_;
  const BlockGhosts<T, D>& ghosts_;
  double h_;
  const T* phi_;
};

// Whether another wall lies before a foot point: the body ends there.
template <int D>
bool is_covered(const Boundaries<D>& boundaries, int wall, const Point<D>& foot) {
  for (int w = 0; w < static_cast<int>(boundaries.walls.size()); ++w) {
    const Wall<D>& other = boundaries.walls[w];
    if (w != wall && other.is_attached() && other.distance(foot) < 0) return true;
  }
  return false;
}

// Force per area of a load on the surface, towards which `n` points out of the body.
template <class T, int D>
Point<D> load_on(const std::array<T, D>& n, int load, const BoundaryValues<D>& values) {
  Point<D> force = values.traction[load];
  for (int a = 0; a < D; ++a) force[a] -= values.pressure[load] * n[a];
  return force;
}

}  // namespace

template <class T, int D>
void add_boundary_work(const Body<T, D>& body, int block, const Boundaries<D>& boundaries,
                       const BoundaryValues<D>& values, const std::vector<char>& watched,
                       double duration, const kernels::RemeshedTable<T, D>& kernels,
                       Point<D>* impulse, EnergyBudget& budget) {
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  const Shares<T, D> shares(body, ghosts);
  const kernels::Impedance<T> impedance(body.material);
  FitEvaluator<T, D> fits(body, ghosts, kernels);
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    const int wall = ghosts.wall[g], load = ghosts.pressure[g];
    if (wall >= 0 ? watched[wall] == 0 : load < 0) continue;
    if (wall >= 0 && is_covered<D>(boundaries, wall, ghosts.foot[g])) continue;
    const double area = wall >= 0 ? shares.of_wall(g) : shares.of_surface(g);
    if (area == 0) continue;
    const kernels::GhostFits<T, D> fit = fits.of(g);
    if (wall < 0) {
      const auto n = kernels::unit_normal<T, D>(fit.linear);
      const Point<D> force = load_on<T, D>(n, load, values);
      for (int a = 0; a < D; ++a) {
        budget.load_work += duration * area * force[a] * fit.surface.velocity(a);
      }
      continue;
    }
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

template void add_boundary_work<double, 2>(const Body<double, 2>&, int, const Boundaries<2>&,
                                           const BoundaryValues<2>&, const std::vector<char>&,
                                           double, const kernels::RemeshedTable<double, 2>&,
                                           Point<2>*, EnergyBudget&);
template void add_boundary_work<double, 3>(const Body<double, 3>&, int, const Boundaries<3>&,
                                           const BoundaryValues<3>&, const std::vector<char>&,
                                           double, const kernels::RemeshedTable<double, 3>&,
                                           Point<3>*, EnergyBudget&);
template void add_boundary_work<float, 2>(const Body<float, 2>&, int, const Boundaries<2>&,
                                          const BoundaryValues<2>&, const std::vector<char>&,
                                          double, const kernels::RemeshedTable<float, 2>&,
                                          Point<2>*, EnergyBudget&);
template void add_boundary_work<float, 3>(const Body<float, 3>&, int, const Boundaries<3>&,
                                          const BoundaryValues<3>&, const std::vector<char>&,
                                          double, const kernels::RemeshedTable<float, 3>&,
                                          Point<3>*, EnergyBudget&);

}  // namespace pliant::remeshed
