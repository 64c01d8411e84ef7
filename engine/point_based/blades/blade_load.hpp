#pragma once

#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// What a blade does to its body.
template <int D>
struct BladeLoad {
  Point<D> impulse = {};  ///< up to when the velocities are [N s]
  Point<D> force = {};    ///< in the last step [N]
  double work = 0;        ///< that cut faces and friction have taken, up to there (PB.19) [J]
  double power = 0;       ///< its rate in the last step [W]
};

}  // namespace pliant::point_based
