#pragma once

#include "engine/case/case.hpp"
#include "engine/remeshed/state/body.hpp"

namespace pliant::remeshed {

/// Gives the slots of `spare` the fields of t = 0, in `stage[1]`, and `valid` 1 where there are
/// particles or ghosts. Returns whether the body has a free surface.
template <class T, int D>
bool set_initial_fields(const Case& settings, Body<T, D>& body, T* valid);

}  // namespace pliant::remeshed
