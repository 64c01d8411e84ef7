#pragma once

#include <vector>

#include "engine/boundaries/walls.hpp"

namespace pliant {

/// What the boundaries impose at one time.
template <int D>
struct BoundaryValues {
  std::vector<Point<D>> wall_velocity;  ///< [wall] [m/s]
  std::vector<double> pressure;         ///< [pressure] [Pa]

  void evaluate(const Boundaries<D>& boundaries, double t);
};

}  // namespace pliant
