#pragma once

#include <cstdint>
#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/boundaries/walls.hpp"
#include "engine/method/step_clock.hpp"
#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Counters that the next step reads; a checkpoint holds all of them. The wave speed is that of
/// (TL.9), without scaling of the mass.
struct Clock : StepClock {
  double mass_scaling = 1;  ///< inertia over mass in the next step
  double damping = 0;       ///< alpha of (TL.8) in the next step [1/s]
};

template <class T, int D>
struct State {
  Clock clock;
  Boundaries<D> boundaries;
  std::vector<Body<T, D>> bodies;
  std::vector<BlockOwner> blocks;
};

}  // namespace pliant::total_lagrangian
