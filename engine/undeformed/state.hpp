#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/boundaries/walls.hpp"
#include "engine/boundaries/wrench.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/undeformed/clock.hpp"

namespace pliant::undeformed {

/// All corners that are nearer to a wall than a distance.
struct NearCorners {
  double unspent = 0;  ///< how far surfaces and wall may still approach until the next search [m]
  std::vector<std::vector<std::int32_t>> corners;  ///< [surface] ascending
};

/// What may soon meet a wall, and what may meet it later.
struct NearWall {
  double speed = 0;  ///< bound on the speed of the surfaces until the next search [m/s]
  NearCorners soon, later;
};

/// The common part of the states of all methods on the undeformed body, without the bodies.
template <int D>
struct State {
  explicit State(const Case& settings)
      : boundaries(settings.boundaries),
        wall_impulse(boundaries.walls.size()),
        wall_force(boundaries.walls.size()),
        contact_impulse(settings.contacts.size()),
        contact_force(settings.contacts.size()) {
    for (const ContactCase& contact : settings.contacts) contact_bodies.push_back(contact.bodies);
  }

  Clock clock;
  EnergyBudget energy;  ///< until the time of the velocities
  EnergyBudget power;   ///< its rates at that time [W]
  Boundaries<D> boundaries;
  std::vector<Wrench<D>> wall_impulse;  ///< [wall] on the bodies, until then [N s], [N m s]
  std::vector<Wrench<D>> wall_force;    ///< [wall] on the bodies, in the last step [N], [N m]
  std::vector<NearWall> near_walls;     ///< [wall that surfaces may meet]
  /// A contact wall that has pushed a particle inside a body since the start of the program.
  const BoundaryCase* tool_inside = nullptr;
  std::vector<std::array<int, 2>> contact_bodies;
  std::vector<Point<D>> contact_impulse;  ///< [contact] on its first body, until then [N s]
  std::vector<Point<D>> contact_force;    ///< [contact] the same, in the last step [N]
  /// Displacements of the carriers of all surfaces when contact last made lists, (TL.20) [m]: a
  /// resumed run then makes the same lists.
  std::vector<Point<D>> contact_marks;
  bool has_new_marks = true;  ///< contact has not made lists from them yet
  std::vector<BlockOwner> blocks;

  /// Impulse of a wall on the bodies until the present time.
  Wrench<D> impulse_of_wall(const MeasurementCase& m) const {
    const int wall = boundaries.wall_of[m.boundary];
    Wrench<D> impulse = wall_impulse[wall];
    impulse.add(wall_force[wall], clock.lag());
    return impulse;
  }
  /// Impulse of a contact on the first body of the measurement until the present time [N s].
  double contact_impulse_on_first(const MeasurementCase& m) const {
    double sum = 0;
    for (std::size_t c = 0; c < contact_bodies.size(); ++c) {
      const double on_first = contact_impulse[c][m.axis] + clock.lag() * contact_force[c][m.axis];
      if (contact_bodies[c] == m.bodies) sum += on_first;
      if (contact_bodies[c] == std::array{m.bodies[1], m.bodies[0]}) sum -= on_first;
    }
    return sum;
  }
};

}  // namespace pliant::undeformed
