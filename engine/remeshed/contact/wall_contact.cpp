#include "engine/remeshed/contact/wall_contact.hpp"

#include <cmath>

#include "engine/remeshed/contact/contact_edges.hpp"
#include "engine/remeshed/ghosts/fit_evaluator.hpp"
#include "engine/remeshed/ghosts/present_foot.hpp"
#include "engine/remeshed/ghosts/wall_site.hpp"
#include "engine/remeshed/loads/wall_work.hpp"
#include "kernels/remeshed/ghosts/wall_friction.hpp"

namespace pliant::remeshed {

namespace {

// Largest height of the surface above the wall where it touched before [h]. After compression and
// remeshing, heights of a few hundredths of h are noise. If they released a slot under pressure for
// a few steps, the body would hit the wall and lose that energy.
constexpr double leaving_height = 0.3;

constexpr double rounding = 1e-9;  // [h], of the place of a slot

template <class T, int D>
T pressure_on(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::int32_t g,
              const Surroundings<D>& around, FitEvaluator<T, D>& fits) {
  return kernels::WallTraction<T, D>(fits.of(g), wall_site<T, D>(body, ghosts, g, around),
                                     kernels::Impedance<T>(body.material))
      .pressure;
}

// Of the two ghosts of a slot, that of the wall comes second.
template <class T, int D>
void choose(Population<T, D>& population, BlockGhosts<T, D>& ghosts, std::int32_t g,
            bool contact_points) {
  ghosts.active[g] = contact_points;
  ghosts.active[g - 1] = !contact_points;
  population.kind[ghosts.slot[g]] = contact_points ? Kind::wall_ghost : Kind::free_ghost;
}

}  // namespace

template <class T, int D>
void decide_contact(Body<T, D>& body, int block, const Surroundings<D>& around,
                    const kernels::RemeshedTable<T, D>& table) {
  BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  FitEvaluator<T, D> fits(body, ghosts, table);
  for (std::size_t k = 0; k < ghosts.contact.size(); ++k) {
    const std::int32_t g = ghosts.contact[k];
    if (ghosts.edge[g] != no_edge) continue;
    const Point<D>& n = ghosts.normal[g];
    double height = ghosts.contact_height[k];
    for (int a = 0; a < D; ++a) {
      height += n[a] * (body.stage[0].get(Field::drift, a)[ghosts.slot[g]] -
                        around.boundaries.walls[ghosts.wall[g]].pose().offset[a]);
    }
    const double reach = ghosts.active[g] != 0 ? leaving_height : contact_onset_height;
    choose(body.population, ghosts, g,
           height < reach * body.lattice.spacing && pressure_on(body, ghosts, g, around, fits) > 0);
  }
}

template <class T, int D>
void release_contact(Body<T, D>& body, int block, const Surroundings<D>& around,
                     const kernels::RemeshedTable<T, D>& table) {
  BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  FitEvaluator<T, D> fits(body, ghosts, table);
  for (const std::int32_t g : ghosts.contact) {
    if (ghosts.edge[g] != no_edge || ghosts.active[g] == 0) continue;
    if (!(pressure_on(body, ghosts, g, around, fits) > 0)) {
      choose(body.population, ghosts, g, false);
    }
  }
}

template <class T, int D>
bool add_impulse(const Body<T, D>& body, int block, int stage, const Surroundings<D>& around,
                 double duration, const kernels::RemeshedTable<T, D>& table,
                 std::span<WallPush<D>> pushes, Point<D>* impulse, EnergyBudget& energy) {
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  FitEvaluator<T, D> fits(body, ghosts, table);
  const kernels::Impedance<T> impedance(body.material);
  bool sticks = false;
  for (std::size_t k = 0; k < ghosts.contact.size(); ++k) {
    const std::int32_t g = ghosts.contact[k];
    if (ghosts.active[g] == 0 || ghosts.contact_area[k] == 0) continue;
    const int wall = ghosts.wall[g];
    const kernels::GhostFits<T, D> present = fits.of(g);
    const auto traction = kernels::traction_on_wall<T, D>(
        present, wall_site<T, D>(body, ghosts, g, around), impedance);
    // A fit extrapolated beyond an edge may pull; the wall does not.
    if (!(traction.pressure > 0)) continue;
    sticks = sticks || !traction.slides;
    const double area =
        ghosts.contact_area[k] * growth_on_wall(body, ghosts, static_cast<std::size_t>(g), stage);
    const Point<D>& u_wall = around.values.wall_motion[wall].velocity;
    Point<D> given;
    for (int a = 0; a < D; ++a) {
      const T push = traction.pressure * static_cast<T>(ghosts.normal[g][a]) + traction.shear[a];
      given[a] = duration * area * push;
      impulse[wall][a] += given[a];
      energy.wall_work += given[a] * u_wall[a];
      if (!traction.slides) continue;
      const double slip = present.surface.velocity(a) - u_wall[a];
      energy.friction -= duration * area * traction.shear[a] * slip;
    }
    if (!pushes.empty()) {
      pushes[wall].add(present_foot(body, ghosts, static_cast<std::size_t>(g), stage), given,
                       duration * area);
    }
  }
  return sticks;
}

template <class T, int D>
std::vector<double> wall_pressure(const Body<T, D>& body, const Surroundings<D>& around,
                                  const kernels::RemeshedTable<T, D>& table) {
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  std::vector<double> pressure(layout.slots(), 0);
  for (const BlockGhosts<T, D>& ghosts : body.population.ghosts) {
    FitEvaluator<T, D> fits(body, ghosts, table);
    for (const std::int32_t g : ghosts.contact) {
      if (ghosts.active[g] == 0) continue;
      const std::int64_t slot = ghosts.slot[g];
      const Wall<D>& wall = around.boundaries.walls[ghosts.wall[g]];
      if (wall.distance(body.lattice.node(layout.cell(slot))) < -(1 + rounding) * h) continue;
      pressure[slot] += pressure_on(body, ghosts, g, around, fits);
    }
  }
  return pressure;
}

template void decide_contact<double, 2>(Body<double, 2>&, int, const Surroundings<2>&,
                                        const kernels::RemeshedTable<double, 2>&);
template void release_contact<double, 2>(Body<double, 2>&, int, const Surroundings<2>&,
                                         const kernels::RemeshedTable<double, 2>&);
template bool add_impulse<double, 2>(const Body<double, 2>&, int, int, const Surroundings<2>&,
                                     double, const kernels::RemeshedTable<double, 2>&,
                                     std::span<WallPush<2>>, Point<2>*, EnergyBudget&);
template std::vector<double> wall_pressure(const Body<double, 2>&, const Surroundings<2>&,
                                           const kernels::RemeshedTable<double, 2>&);
template void decide_contact<double, 3>(Body<double, 3>&, int, const Surroundings<3>&,
                                        const kernels::RemeshedTable<double, 3>&);
template void release_contact<double, 3>(Body<double, 3>&, int, const Surroundings<3>&,
                                         const kernels::RemeshedTable<double, 3>&);
template bool add_impulse<double, 3>(const Body<double, 3>&, int, int, const Surroundings<3>&,
                                     double, const kernels::RemeshedTable<double, 3>&,
                                     std::span<WallPush<3>>, Point<3>*, EnergyBudget&);
template std::vector<double> wall_pressure(const Body<double, 3>&, const Surroundings<3>&,
                                           const kernels::RemeshedTable<double, 3>&);
template void decide_contact<float, 2>(Body<float, 2>&, int, const Surroundings<2>&,
                                       const kernels::RemeshedTable<float, 2>&);
template void release_contact<float, 2>(Body<float, 2>&, int, const Surroundings<2>&,
                                        const kernels::RemeshedTable<float, 2>&);
template bool add_impulse<float, 2>(const Body<float, 2>&, int, int, const Surroundings<2>&, double,
                                    const kernels::RemeshedTable<float, 2>&, std::span<WallPush<2>>,
                                    Point<2>*, EnergyBudget&);
template std::vector<double> wall_pressure(const Body<float, 2>&, const Surroundings<2>&,
                                           const kernels::RemeshedTable<float, 2>&);
template void decide_contact<float, 3>(Body<float, 3>&, int, const Surroundings<3>&,
                                       const kernels::RemeshedTable<float, 3>&);
template void release_contact<float, 3>(Body<float, 3>&, int, const Surroundings<3>&,
                                        const kernels::RemeshedTable<float, 3>&);
template bool add_impulse<float, 3>(const Body<float, 3>&, int, int, const Surroundings<3>&, double,
                                    const kernels::RemeshedTable<float, 3>&, std::span<WallPush<3>>,
                                    Point<3>*, EnergyBudget&);
template std::vector<double> wall_pressure(const Body<float, 3>&, const Surroundings<3>&,
                                           const kernels::RemeshedTable<float, 3>&);

}  // namespace pliant::remeshed
