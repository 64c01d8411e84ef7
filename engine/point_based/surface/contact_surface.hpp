#pragma once

#include <cstddef>
#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::point_based {

/// What a corner of the undeformed surface moves with, (TL.15): the node nearest to it, first, and
/// where that lies elsewhere those that the node has bonds with, as its gradient (PB.4) says.
/// Blades change bonds: in a body with cuts corners follow the nearest node alone.
template <class T, int D>
std::vector<undeformed::Share> shares_of_corner(const Body<T, D>& body, std::size_t corner);

/// The facets of a body for contact. In a body with cuts all nodes are corners too, as any of them
/// may come to lie on the surface.
template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body);

}  // namespace pliant::point_based
