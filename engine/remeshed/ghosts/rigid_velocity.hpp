#pragma once

#include <array>

#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// (RP.59): the mean rigid motion of the neighbours of a ghost at a stage, taken at the ghost
/// [m/s].
template <class T, int D>
std::array<T, D> rigid_velocity(const Body<T, D>& body, int stage, const BlockGhosts<T, D>& ghosts,
                                std::size_t ghost);

}  // namespace pliant::remeshed
