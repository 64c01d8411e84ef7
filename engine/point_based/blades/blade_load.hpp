#pragma once

#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// The effect of a blade on its body.
template <int D>
struct BladeLoad {
  Point<D> impulse = {};  ///< until the time of the velocities [N s]
  Point<D> force = {};    ///< in the last step [N]
  double work = 0;        ///< taken by new cut faces and friction until that time, (PB.19) [J]
  double power = 0;       ///< rate of this work in the last step [W]
};

}  // namespace pliant::point_based
