#pragma once

#include <cmath>

#include "engine/remeshed/ghosts/fit_coefficient.hpp"
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

/// x_w of (RP.114): the point of a wall that turns with whose velocity (RP.46) gives a body that
/// turns with it the velocity of the wall's solid at ghost g.
template <class T, int D>
Point<D> point_of_extrapolation(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                std::size_t g) {
  Point<D> mean = {};  // sum b r, over h
  for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
    const FittedParticle<T, D> particle(ghosts, g, k);
    const T phi = ghosts.wall_distance[ghosts.wall_begin[g] + (k - ghosts.begin[g])];
    const T b = kernels::fit_coefficients(particle.terms, particle.r, phi).constrained;
    for (int a = 0; a < D; ++a) mean[a] += b * particle.r[a];
  }
  const Point<D> node = body.lattice.node(body.population.layout.cell(ghosts.slot[g]));
  Point<D> x = ghosts.foot[g];
  for (int a = 0; a < D; ++a) {
    x[a] += (node[a] - x[a] - body.lattice.spacing * mean[a]) / (1 - ghosts.constrained_sum[g]);
  }
  return x;
}

/// u_w of (RP.46) for ghost g, (RP.114).
template <class T, int D>
Point<D> velocity_beyond(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                         const RigidMotion<D>& wall) {
  return wall.turns ? wall.of(point_of_extrapolation(body, ghosts, g)) : wall.velocity;
}

/// The wall at ghost g. Behind walls with slip, sigma_nn rises with the depth by body forces alone,
/// (RP.79).
template <class T, int D>
kernels::WallSite<T, D> wall_site(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts,
                                  std::size_t g, const Surroundings<D>& around) {
  const int w = ghosts.wall[g];
  const RigidMotion<D>& motion = around.values.wall_motion[w];
  const Point<D> velocity = motion.of(ghosts.foot[g]), n = motion.turned(ghosts.normal[g]);
  const Point<D> beyond = velocity_beyond(body, ghosts, g, motion);
  kernels::WallSite<T, D> site;
  site.friction = static_cast<T>(around.boundaries.walls[w].friction());
  for (int a = 0; a < D; ++a) {
    site.velocity[a] = static_cast<T>(velocity[a]);
    site.beyond[a] = static_cast<T>(beyond[a]);
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
