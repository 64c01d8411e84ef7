#pragma once

#include <vector>

#include "engine/total_lagrangian/body.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::total_lagrangian {

using undeformed::Clock;

template <class T, int D>
struct State : undeformed::State<D> {
  using undeformed::State<D>::State;

  std::vector<Body<T, D>> bodies;

  /// Sets the time since the bodies' stress was evaluated.
  void age_memory() {
    const double start = this->clock.step_end - this->clock.step_length;
    for (Body<T, D>& body : bodies) body.memory_age = this->clock.time - start;
  }
};

}  // namespace pliant::total_lagrangian
