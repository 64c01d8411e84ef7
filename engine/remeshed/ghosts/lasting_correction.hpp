#pragma once

#include <cmath>

#include "engine/remeshed/state/body.hpp"

/// The velocities of (RP.50) and (RP.47) let waves leave a body within a few h/c. In bodies that
/// are held bent or rest on a wall, a part of them is lasting and feeds a checkerboard of stress.
namespace pliant::remeshed {

/// Whether the dissipation of (RP.23) also relaxes shear stress. A body under a lasting load
/// would then creep. Other bodies in 2D with a linear material need it: their ghosts move with all
/// of (RP.50), which feeds modes that it damps.
template <class T, int D>
bool relaxes_shear(const Body<T, D>& body) {
  return D == 2 && !kernels::carries_deformation(body.material.model) && !body.bears_loads;
}

/// Whether ghosts move without the lasting part of (RP.50) and (RP.95). Bodies whose shear stress
/// does not relax are unstable with it where they are held. Others are stable with all of it and
/// lose less energy, but creep where they rest on a contact wall.
template <class T, int D>
bool removes_lasting_correction(const Body<T, D>& body, const Boundaries<D>& boundaries) {
  return !relaxes_shear(body) || boundaries.have_contact();
}

constexpr double lasting_time = 20;  ///< averaging time of (RP.50) [h/c]

/// Subtracts the lasting part of (RP.50) from the velocity of the first `count` ghosts of a
/// block.
template <class T, int D>
void remove_lasting_correction(BlockGhosts<T, D>& ghosts, std::size_t count,
                               FieldStore<T, D>& state) {
  for (std::size_t g = 0; g < count; ++g) {
    if (ghosts.wall[g] >= 0 || ghosts.active[g] == 0) continue;
    for (int a = 0; a < D; ++a) {
      ghosts.correction[g][a] -= ghosts.lasting[g][a];
      state.get(Field::velocity, a)[ghosts.slot[g]] -= ghosts.lasting[g][a];
    }
  }
}

/// Updates the lasting parts of (RP.50) and (RP.95) after a time step [s].
template <class T, int D>
void follow_lasting(const Body<T, D>& body, BlockGhosts<T, D>& ghosts, double time_step) {
  const double speed = kernels::wave_speed_at_rest(body.material);
  const auto share =
      static_cast<T>(1 - std::exp(-time_step * speed / (lasting_time * body.lattice.spacing)));
  for (std::size_t g = 0; g < ghosts.reached_count; ++g) {
    if (ghosts.active[g] == 0) continue;
    for (int a = 0; a < D; ++a) ghosts.lasting[g][a] += share * ghosts.correction[g][a];
  }
}

}  // namespace pliant::remeshed
