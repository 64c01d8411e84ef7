#pragma once

#include <vector>

#include "engine/boundaries/walls.hpp"

namespace pliant {

/// The values of the boundary conditions at one time.
template <int D>
struct BoundaryValues {
  std::vector<Point<D>> wall_velocity;  ///< [wall] [m/s]
  std::vector<double> pressure;         ///< [pressure] [Pa]; 0 for a traction
  std::vector<Point<D>> traction;       ///< [pressure] [Pa], at the origin; 0 for a pressure

  void evaluate(const Boundaries<D>& boundaries, double t);
};

}  // namespace pliant
