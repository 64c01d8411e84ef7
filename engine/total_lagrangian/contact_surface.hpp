#pragma once

#include "engine/total_lagrangian/body.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::total_lagrangian {

/// The facets of a body for contact with other bodies. Each corner lies between two particles and
/// moves with them.
template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body);

/// Adds the particles between cells that are in the body as a whole, as corners without facets.
template <class T, int D>
void add_inner_particles(const Body<T, D>& body, undeformed::ContactSurface<D>& surface);

}  // namespace pliant::total_lagrangian
