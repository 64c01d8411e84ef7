#pragma once

#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::point_based {

using undeformed::Clock;

/// What a blade does to its body.
template <int D>
struct BladeLoad {
  Point<D> impulse = {};  ///< up to when the velocities are [N s]
  Point<D> force = {};    ///< in the last step [N]
  double work = 0;        ///< that cut faces and friction have taken, up to there (PB.19) [J]
  double power = 0;       ///< its rate in the last step [W]
};

template <class T, int D>
struct State : undeformed::State<D> {
  using undeformed::State<D>::State;

  std::vector<Body<T, D>> bodies;
  std::vector<BladeLoad<D>> blades;  ///< [cut of the case]
};

}  // namespace pliant::point_based
