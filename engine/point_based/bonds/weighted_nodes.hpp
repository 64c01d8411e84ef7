#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/lattice/lattice.hpp"

namespace pliant::point_based {

/// Nodes with weighted bonds, and their shares of the body's surface.
template <int D>
struct WeightedNodes {
  std::vector<Point<D>> positions;                   ///< [node] [m]
  std::vector<double> volumes;                       ///< [node] V [m^D]
  std::vector<Point<D>> areas;                       ///< [node] a, outwards [m^(D-1)]
  std::vector<std::vector<std::int32_t>> neighbour;  ///< [node][bond] may be empty
  std::vector<std::vector<double>> weight;           ///< [node][bond] positive
  /// [node] row-major projection onto the directions in which no wall takes the force; empty: all
  std::vector<std::array<double, D * D>> free;
};

}  // namespace pliant::point_based
