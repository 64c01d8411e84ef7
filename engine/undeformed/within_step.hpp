#pragma once

#include <algorithm>
#include <vector>

#include "engine/undeformed/body.hpp"
#include "engine/undeformed/clock.hpp"

/// Particles at an output time inside a step, (PB.45). If velocities belong to the middle of the
/// step (they lag), particles move on straight lines. Otherwise their velocities are interpolated
/// between those at its start and at its end.
namespace pliant::undeformed {

/// Called before a step: stores the velocities at its start, to get their gain at its end.
template <class T, int D>
void store_start(Body<T, D>& body, bool velocities_lag) {
  if (velocities_lag) return;
  for (int a = 0; a < D; ++a) {
    std::copy_n(body.velocity[a].get(), body.slots, body.velocity_gain[a].get());
  }
}

/// Called after a step: stores its end, since returning from an output time would round.
template <class T, int D>
void store_end(Body<T, D>& body, bool velocities_lag) {
  for (int a = 0; a < D; ++a) {
    std::copy_n(body.displacement[a].get(), body.slots, body.end_displacement[a].get());
    if (velocities_lag) continue;
    const T* const velocity = body.velocity[a].get();
    T* const gain = body.velocity_gain[a].get();
    std::copy_n(velocity, body.slots, body.end_velocity[a].get());
    for (std::int64_t p = 0; p < body.slots; ++p) gain[p] = velocity[p] - gain[p];
  }
}

/// Moves a body from the stored end of the step to the present time of the clock, (PB.45).
template <class T, int D>
void move_to_output(Body<T, D>& body, const Clock& clock, bool velocities_lag) {
  const T back = static_cast<T>(clock.rest()), half = static_cast<T>(clock.step_length / 2);
  const T share = static_cast<T>(clock.rest() / clock.step_length);
  for (int a = 0; a < D; ++a) {
    const T* const end = body.end_displacement[a].get();
    T* const velocity = body.velocity[a].get();
    T* const displacement = body.displacement[a].get();
    if (velocities_lag) {
      for (std::int64_t p = 0; p < body.slots; ++p) displacement[p] = end[p] - back * velocity[p];
      continue;
    }
    const T* const end_velocity = body.end_velocity[a].get();
    const T* const gain = body.velocity_gain[a].get();
    if (back == 0) {
      std::copy_n(end, body.slots, displacement);
      std::copy_n(end_velocity, body.slots, velocity);
      continue;
    }
    for (std::int64_t p = 0; p < body.slots; ++p) {
      velocity[p] = end_velocity[p] - share * gain[p];
      displacement[p] = (end[p] - half * end_velocity[p]) + (half - back) * velocity[p];
    }
  }
}

/// Moves bodies to the time of their velocities, `lag` [s] before that of their displacements. The
/// destructor restores the displacements, bit by bit.
template <class Body>
class AtVelocityTime {
  using T = typename Body::Scalar;

 public:
  AtVelocityTime(std::vector<Body>& bodies, double lag) : bodies_(bodies) {
    const T back = static_cast<T>(lag);
    for (Body& body : bodies_) {
      for (int a = 0; a < Body::dimension; ++a) {
        T* const displacement = body.displacement[a].get();
        present_.emplace_back(displacement, displacement + body.slots);
        for (std::int64_t p = 0; p < body.slots; ++p) displacement[p] -= back * body.velocity[a][p];
      }
    }
  }
  AtVelocityTime(const AtVelocityTime&) = delete;
  AtVelocityTime& operator=(const AtVelocityTime&) = delete;
  ~AtVelocityTime() {
    auto kept = present_.begin();
    for (Body& body : bodies_) {
      for (int a = 0; a < Body::dimension; ++a, ++kept) {
        std::copy(kept->begin(), kept->end(), body.displacement[a].get());
      }
    }
  }

 private:
  std::vector<Body>& bodies_;
  std::vector<std::vector<T>> present_;
};

}  // namespace pliant::undeformed
