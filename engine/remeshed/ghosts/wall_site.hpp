#pragma once

#include <cmath>

#include "engine/remeshed/loads/surroundings.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Depth of a ghost's slot behind its wall at the remeshing [m].
template <class T, int D>
double depth_behind_wall(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g) {
  const Point<D> x = body.lattice.node(body.population.layout.cell(ghosts.slot[g]));
  double depth = 0;
  for (int a = 0; a < D; ++a) depth += (ghosts.foot[g][a] - x[a]) * ghosts.normal[g][a];
  return depth;
}

/// The wall at ghost g. Behind walls with slip, sigma_nn rises with the depth by body forces alone,
/// (RP.79).
template <class T, int D>
kernels::WallSite<T, D> wall_site(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                  std::size_t g, const Surroundings<D>& around) {
  const int w = ghosts.wall[g];
  const Point<D>& velocity = around.values.wall_velocity[w];
  const Point<D>& n = ghosts.normal[g];
  kernels::WallSite<T, D> site;
  site.friction = static_cast<T>(around.boundaries.walls[w].friction());
  for (int a = 0; a < D; ++a) {
    site.velocity[a] = static_cast<T>(velocity[a]);
    site.n[a] = static_cast<T>(n[a]);
  }
  if (!around.body_force.acts || !std::isfinite(site.friction)) return site;
  const Point<D> rate = around.body_force(ghosts.foot[g], velocity);
  double along = 0;
  for (int a = 0; a < D; ++a) along += n[a] * rate[a];
  site.rise =
      static_cast<T>(body.material.density * along * depth_behind_wall<T, D>(body, ghosts, g));
  return site;
}

}  // namespace pliant::remeshed
