#pragma once

#include <vector>

#include "engine/boundaries/walls.hpp"

namespace pliant {

/// What the boundaries impose at one time.
template <int D>
struct BoundaryValues {
  std::vector<Point<D>> wall_velocity;  ///< [wall] [m/s]
  std::vector<double> pressure;         ///< [pressure] [Pa], 0 of a traction
  std::vector<Point<D>> traction;       ///< [pressure] [Pa], at the origin; 0 of a pressure

  void evaluate(const Boundaries<D>& boundaries, double t);
};

}  // namespace pliant
