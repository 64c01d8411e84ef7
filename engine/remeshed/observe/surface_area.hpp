#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// Area of the free surface {phi = 0} in front of all walls [m^2]; in 2D its length [m].
///
/// Every cube of nodes is divided into D! simplices in which phi is linear, so that the surface is
/// a polygon in each; the error decreases as h^2. Facets that cut off an edge of `initial`, the
/// free surface at t = 0, count with what they replace of its faces, as in (RP.72), unless
/// distances to it are expensive.
template <class T, int D>
double surface_area(const LatticeView<T, D>& view, const Boundaries<D>& boundaries,
                    const Shape& initial);

}  // namespace pliant::remeshed
