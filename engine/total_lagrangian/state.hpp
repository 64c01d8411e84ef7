#pragma once

#include <cstdint>
#include <vector>

#include "engine/body/walls.hpp"
#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// Counters that the next step reads; a checkpoint holds all of them.
struct Clock {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double wave_speed = 0;    ///< largest of (TL.9), without scaling of the mass [m/s]
  double mass_scaling = 1;  ///< inertia over mass in the next step
  double damping = 0;       ///< alpha of (TL.8) in the next step [1/s]
};

/// Where a block of the step graph belongs: the blocks of all bodies in one numbering.
struct BlockOwner {
  int body, block;
};

template <class T, int D>
struct State {
  Clock clock;
  Boundaries<D> boundaries;
  std::vector<Body<T, D>> bodies;
  std::vector<BlockOwner> blocks;
};

}  // namespace pliant::total_lagrangian
