#pragma once

#include <vector>

#include "engine/blocks/numbering.hpp"
#include "engine/boundaries/walls.hpp"
#include "engine/method/step_clock.hpp"
#include "engine/point_based/body.hpp"

namespace pliant::point_based {

/// Counters that the next step reads; a checkpoint holds all of them.
struct Clock : StepClock {
  double step_length = 0;  ///< of the last step that began [s]; 0 before the first
  double step_end = 0;     ///< when that step ends [s]

  /// What is left of that step after an output time inside it [s]; 0 where it has ended.
  double rest() const { return step_end - time > rounding() ? step_end - time : 0; }
  /// Times nearer to each other than this are the same [s].
  double rounding() const { return 1e-9 * step_length; }
};

template <class T, int D>
struct State {
  Clock clock;
  Boundaries<D> boundaries;
  std::vector<Body<T, D>> bodies;
  std::vector<BlockOwner> blocks;
};

}  // namespace pliant::point_based
