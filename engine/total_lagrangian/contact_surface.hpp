#pragma once

#include "engine/total_lagrangian/body.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::total_lagrangian {

/// The facets of a body for contact with other bodies; each corner moves with the two particles
/// between which it lies.
template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body);

}  // namespace pliant::total_lagrangian
