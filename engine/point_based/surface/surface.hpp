#pragma once

#include <functional>

#include "engine/boundaries/walls.hpp"
#include "engine/point_based/body.hpp"
#include "engine/point_based/nodes/node_cloud.hpp"

namespace pliant::point_based {

/// Finds the undeformed surface of a body whose nodes are in their slots, and which facets are
/// free. It is the boundary of the elements of the cloud, or else the surface of `shape` between
/// the points of a lattice with this spacing [m].
template <class T, int D>
void make_surface(const NodeCloud<D>& cloud, const Shape& shape, double spacing,
                  const Boundaries<D>& boundaries, Body<T, D>& body);

/// Finds the nodes that loads act on; the body must have its surface and its bonds.
template <class T, int D>
void make_loads(const Boundaries<D>& boundaries, Body<T, D>& body);

/// A function that tells whether a place is inside `shape` and farther than `edge` [m] from its
/// surface.
template <int D>
std::function<bool(const Point<D>&)> inside_of(const Shape& shape, double edge);

}  // namespace pliant::point_based
