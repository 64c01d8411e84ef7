#pragma once

#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/total_lagrangian/body.hpp"

/// Fits particles to walls and to the rims at which walls end on a free surface, (TL.11).
namespace pliant::total_lagrangian {

inline constexpr double on_surface = 1e-9;  ///< [h] rounding errors of distances

/// The particles that move from their nodes, in the order of their slots, and the cells that are
/// flat on a wall then.
template <int D>
struct WallFit {
  std::vector<FittedNode<D>> nodes;
  std::vector<Cell<D>> flat_cells;
};

/// Reads the level set, the particles and which of them walls hold.
template <class T, int D>
WallFit<D> fit_to_walls(const Boundaries<D>& boundaries, const Body<T, D>& body);

}  // namespace pliant::total_lagrangian
