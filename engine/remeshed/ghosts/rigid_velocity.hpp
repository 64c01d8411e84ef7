#pragma once

#include <array>

#include "engine/remeshed/state/state.hpp"

namespace pliant::remeshed {

/// (RP.59): the mean rigid motion of a ghost's neighbours at a stage, evaluated at the ghost [m/s].
template <class T, int D>
std::array<T, D> rigid_velocity(const Body<T, D>& body, int stage, const BlockGhosts<T, D>& ghosts,
                                std::size_t ghost);

}  // namespace pliant::remeshed
