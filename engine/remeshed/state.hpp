#pragma once

#include <cstdint>
#include <vector>

#include "engine/body/walls.hpp"
#include "engine/case/case.hpp"
#include "engine/remeshed/body.hpp"

namespace pliant::remeshed {

/// Counters that the next step reads; a checkpoint holds all of them.
struct Clock {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::int64_t remeshings = 0;
  std::int64_t steps_since_remeshing = 0;
  std::int64_t steps_since_reinitialisation = 0;
  double accumulated_strain = 0;  ///< of (RP.28), since the last remeshing
  double wave_speed = 0;          ///< largest, at the present state [m/s]
};

/// Where a block of the step graph belongs: the blocks of all bodies in one numbering.
struct BlockOwner {
  int body, block;
};

/// What a body in contact holds to, see body_momentum.hpp.
template <int D>
struct Book {
  double mass = 0;         ///< at t = 0 [kg]
  Point<D> momentum = {};  ///< [N s]
};

template <class T, int D>
struct State {
  Clock clock;
  Boundaries<D> boundaries;
  std::vector<Point<D>> wall_impulse;  ///< [wall] of contact walls on the bodies, since t = 0 [N s]
  std::vector<Point<D>> contact_impulse;  ///< [contact] on its second body, since t = 0 [N s]
  std::vector<Body<T, D>> bodies;
  std::vector<Book<D>> books;  ///< [body], or none without contacts between bodies
  std::vector<BlockOwner> blocks;
};

}  // namespace pliant::remeshed
