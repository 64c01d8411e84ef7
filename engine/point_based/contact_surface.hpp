#pragma once

#include "engine/point_based/body.hpp"
#include "engine/undeformed/contact_surface.hpp"

namespace pliant::point_based {

/// The facets of a body for contact with other bodies. A corner moves with the node nearest to it
/// and, where that lies elsewhere, with those that the node has bonds with, as its gradient (PB.4)
/// says. Blades change bonds: in a body with cuts corners follow the nearest node alone, and all
/// nodes are corners too, as any of them may come to lie on the surface.
template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body);

}  // namespace pliant::point_based
