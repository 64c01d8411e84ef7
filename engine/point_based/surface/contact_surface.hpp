#pragma once

#include <cstddef>
#include <vector>

#include "engine/point_based/body.hpp"
#include "engine/undeformed/contact/contact_surface.hpp"

namespace pliant::point_based {

/// The nodes that a corner of the undeformed surface moves with, (TL.15): first the nearest node.
/// If the corner is not at that node, the neighbours of the node follow, by its linear fit.
/// Since blades change bonds, corners of a body with cuts move with the nearest node alone.
template <class T, int D>
std::vector<undeformed::Share> shares_of_corner(const Body<T, D>& body, std::size_t corner);

/// The facets of a body for contact. In a body with cuts all nodes are corners too, since any of
/// them may come to lie on the surface.
template <class T, int D>
undeformed::ContactSurface<D> contact_surface(const Body<T, D>& body);

/// Adds the nodes that are no corners yet, as corners without facets.
template <class T, int D>
void add_inner_particles(const Body<T, D>& body, undeformed::ContactSurface<D>& surface);

}  // namespace pliant::point_based
