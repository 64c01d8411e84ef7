#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/point_based/cutting/body_cuts.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::point_based {

using undeformed::Clock;

template <class T, int D>
struct State : undeformed::State<D> {
  using undeformed::State<D>::State;

  std::vector<Body<T, D>> bodies;
  /// [body] null for a body without cuts; shorter where the last bodies have none.
  std::vector<std::unique_ptr<BodyCuts<T, D>>> cuts;

  /// The cuts of a body so far.
  std::span<const CutSurface<D>> cut_surfaces(std::size_t body) const {
    if (body >= cuts.size() || !cuts[body]) return {};
    return cuts[body]->surfaces();
  }
  /// Sets the time since the memory of the bodies was advanced with the forces of the last step,
  /// which acted in its middle (`leapfrog`) or at its start.
  void age_memory(bool leapfrog) {
    const Clock& clock = this->clock;
    const double forces = clock.step_end - clock.step_length * (leapfrog ? 0.5 : 1);
    for (Body<T, D>& body : bodies) body.memory_age = std::max(0., clock.time - forces);
  }
  /// Estimate of the highest squared frequency of all bodies, (PB.12) [1/s^2].
  double frequency2 = 0;
  std::vector<BladeLoad<D>> blades;  ///< [cut of the case]
};

}  // namespace pliant::point_based
