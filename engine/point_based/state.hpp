#pragma once

#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/undeformed/state.hpp"

namespace pliant::point_based {

using undeformed::Clock;

template <class T, int D>
struct State : undeformed::State<D> {
  using undeformed::State<D>::State;

  std::vector<Body<T, D>> bodies;
  /// Estimate of the highest squared frequency of all bodies, (PB.12) [1/s^2].
  double frequency2 = 0;
};

}  // namespace pliant::point_based
