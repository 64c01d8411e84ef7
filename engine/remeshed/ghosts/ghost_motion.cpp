#include "engine/remeshed/ghosts/ghost_motion.hpp"

#include <algorithm>
#include <array>

#include "engine/remeshed/ghosts/lasting_correction.hpp"
#include "engine/remeshed/ghosts/rigid_velocity.hpp"
#include "engine/remeshed/ghosts/wall_site.hpp"
#include "kernels/remeshed/ghosts/ghost_state.hpp"

namespace pliant::remeshed {

namespace {

// Sums are computed for a few ghosts at a time, so that they stay in the first cache.
template <class T, int D>
void find_drift_velocity(Body<T, D>& body, int block, int stage, const BoundaryValues<D>& values,
                         GhostTreatment treatment, const kernels::RemeshedTable<T, D>& table) {
  constexpr std::size_t at_once = 32, width = BlockGhosts<T, D>::sums_of_ghost;
  alignas(64) std::array<T, at_once * width> sums;
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  FieldStore<T, D>& state = body.stage[buffer_of(stage)];
  for (std::size_t begin = ghosts.reached_count; begin < ghosts.slot.size(); begin += at_once) {
    const std::size_t end = std::min(begin + at_once, ghosts.slot.size());
    table.sum_velocities(ghosts.sums(begin, end - begin, body, sums.data()));
    for (std::size_t g = begin; g < end; ++g) {
      const auto fits = ghosts.fits(g, sums.data() + width * (g - begin));
      std::array<T, D> u;
      if (ghosts.wall[g] >= 0) {
        const Point<D> wall = velocity_beyond(body, ghosts, g, values.wall_motion[ghosts.wall[g]]);
        std::copy(wall.begin(), wall.end(), u.begin());
        u = kernels::wall_ghost_velocity<T, D>(fits, u);
      } else if (treatment == GhostTreatment::rigid) {
        u = rigid_velocity<T, D>(body, stage, ghosts, g);
      } else {
        for (int a = 0; a < D; ++a) u[a] = fits.linear.velocity(a);
      }
      for (int a = 0; a < D; ++a) state.get(Field::velocity, a)[ghosts.slot[g]] = u[a];
    }
  }
}

}  // namespace

template <class T, int D>
void drift_ghosts(Body<T, D>& body, int block, int stage, const BoundaryValues<D>& values,
                  GhostTreatment treatment, const kernels::RemeshedTable<T, D>& table) {
  if (stage < 2) return find_drift_velocity(body, block, stage, values, treatment, table);
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  for (int a = 0; a < D; ++a) {
    const T* start = body.stage[0].get(Field::velocity, a);
    T* second = body.stage[1].get(Field::velocity, a);
    T* third = body.stage[2].get(Field::velocity, a);
    for (std::size_t g = ghosts.reached_count; g < ghosts.slot.size(); ++g) {
      const std::int64_t slot = ghosts.slot[g];
      if (stage == 2) {
        third[slot] = (4 * second[slot] - start[slot]) / 3;
      } else {
        second[slot] = third[slot];
      }
    }
  }
}

template <class T, int D>
void keep_on_fits(Body<T, D>& body, int block, int stage, double time_step,
                  const Boundaries<D>& boundaries) {
  BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  if (stage == 0 && removes_lasting_correction(body, boundaries)) {
    follow_lasting(body, ghosts, time_step);
  }
  const FieldStore<T, D>& current = body.stage[buffer_of(stage)];
  const FieldStore<T, D>& place = body.stage[drift_buffer_of(stage)];
  FieldStore<T, D>& next = body.stage[drift_buffer_after(stage)];
  const T weight = static_cast<T>(stage_weight[stage] * time_step);
  const T duration = static_cast<T>(stage_share[stage] * time_step);
  for (std::size_t g = 0; g < ghosts.reached_count; ++g) {
    const bool may_be_in_contact =
        g + 1 < ghosts.reached_count && ghosts.slot[g + 1] == ghosts.slot[g];
    if (ghosts.wall[g] >= 0 || may_be_in_contact) continue;
    const std::int64_t slot = ghosts.slot[g];
    for (int a = 0; a < D; ++a) {
      T& initial_drift = ghosts.initial_drift[g][a];
      T& drift_increment = ghosts.drift_increment[g][a];
      if (stage == 0) {
        initial_drift = place.get(Field::drift, a)[slot];
        drift_increment = 0;
      }
      const T u = current.get(Field::velocity, a)[slot] - ghosts.correction[g][a];
      drift_increment += weight * u;
      next.get(Field::drift, a)[slot] =
          initial_drift + (stage < 3 ? duration * u : drift_increment);
    }
  }
}

template void drift_ghosts<double, 2>(Body<double, 2>&, int, int, const BoundaryValues<2>&,
                                      GhostTreatment, const kernels::RemeshedTable<double, 2>&);
template void keep_on_fits<double, 2>(Body<double, 2>&, int, int, double, const Boundaries<2>&);
template void drift_ghosts<float, 2>(Body<float, 2>&, int, int, const BoundaryValues<2>&,
                                     GhostTreatment, const kernels::RemeshedTable<float, 2>&);
template void keep_on_fits<float, 2>(Body<float, 2>&, int, int, double, const Boundaries<2>&);
template void drift_ghosts<double, 3>(Body<double, 3>&, int, int, const BoundaryValues<3>&,
                                      GhostTreatment, const kernels::RemeshedTable<double, 3>&);
template void keep_on_fits<double, 3>(Body<double, 3>&, int, int, double, const Boundaries<3>&);
template void drift_ghosts<float, 3>(Body<float, 3>&, int, int, const BoundaryValues<3>&,
                                     GhostTreatment, const kernels::RemeshedTable<float, 3>&);
template void keep_on_fits<float, 3>(Body<float, 3>&, int, int, double, const Boundaries<3>&);

}  // namespace pliant::remeshed
