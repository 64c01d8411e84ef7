#pragma once

#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// The place of a ghost's foot point at a stage [m]; it moves like the ghost.
template <class T, int D>
Point<D> present_foot(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::size_t g,
                      int stage) {
  Point<D> x = ghosts.foot[g];
  const FieldStore<T, D>& places = body.stage[drift_buffer_of(stage)];
  for (int a = 0; a < D; ++a) x[a] += places.get(Field::drift, a)[ghosts.slot[g]];
  return x;
}

}  // namespace pliant::remeshed
