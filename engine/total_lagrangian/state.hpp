#pragma once

#include <cstdint>
#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/boundaries/walls.hpp"
#include "engine/method/energy_budget.hpp"
#include "engine/method/step_clock.hpp"
#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Counters that the next step reads; a checkpoint holds all of them. The wave speed is that of
/// (TL.9), without scaling of the mass.
struct Clock : StepClock {
  double mass_scaling = 1;  ///< inertia over mass in the next step
  double damping = 0;       ///< alpha of (TL.8) in the next step [1/s]
  double step_length = 0;   ///< of the last step that began [s]; 0 before the first
  double step_end = 0;      ///< when that step ends [s]

  /// What is left of that step after an output time inside it [s]; 0 where it has ended.
  double rest() const { return step_end - time > rounding() ? step_end - time : 0; }
  /// From the middle of that step, where the velocities are, to `time` [s].
  double lag() const { return time - (step_end - step_length / 2); }
  /// Times nearer to each other than this are the same [s].
  double rounding() const { return 1e-9 * step_length; }
};

template <class T, int D>
struct State {
  Clock clock;
  EnergyBudget energy;  ///< up to the middle of the last step, where velocities are
  EnergyBudget power;   ///< its rates there [W]
  Boundaries<D> boundaries;
  std::vector<Point<D>> wall_impulse;  ///< [wall] on the bodies, up to there [N s]
  std::vector<Point<D>> wall_force;    ///< [wall] on the bodies, in the last step [N]
  std::vector<Body<T, D>> bodies;
  std::vector<BlockOwner> blocks;

  /// Tells the bodies how long ago their stress was evaluated.
  void age_memory() {
    for (Body<T, D>& body : bodies) {
      body.memory_age = clock.time - (clock.step_end - clock.step_length);
    }
  }
};

}  // namespace pliant::total_lagrangian
