#pragma once

#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/boundaries/walls.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/undeformed/clock.hpp"

namespace pliant::undeformed {

/// What the states of all methods on the undeformed body have, apart from the bodies.
template <int D>
struct State {
  explicit State(const std::vector<BoundaryCase>& cases)
      : boundaries(cases),
        wall_impulse(boundaries.walls.size()),
        wall_force(boundaries.walls.size()) {}

  Clock clock;
  EnergyBudget energy;  ///< up to when the velocities are
  EnergyBudget power;   ///< its rates there [W]
  Boundaries<D> boundaries;
  std::vector<Point<D>> wall_impulse;  ///< [wall] on the bodies, up to there [N s]
  std::vector<Point<D>> wall_force;    ///< [wall] on the bodies, in the last step [N]
  std::vector<BlockOwner> blocks;

  /// Impulse of a wall on the bodies up to the present time [N s].
  double impulse(const MeasurementCase& m) const {
    const int wall = boundaries.wall_of[m.boundary];
    return wall_impulse[wall][m.axis] + clock.lag() * wall_force[wall][m.axis];
  }
};

}  // namespace pliant::undeformed
