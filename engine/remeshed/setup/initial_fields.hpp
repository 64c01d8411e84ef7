#pragma once

#include "engine/case/case.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Sets the fields of the slots of `spare` at t = 0, in `stage[1]`, and `valid` to 1 at particles
/// and ghosts. Returns whether the body has a free surface.
template <class T, int D>
bool set_initial_fields(const Case& settings, Body<T, D>& body, T* valid);

}  // namespace pliant::remeshed
