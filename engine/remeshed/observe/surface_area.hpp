#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/state/lattice_view.hpp"

namespace pliant::remeshed {

/// Area of the free surface {phi = 0} in front of all walls [m^2]; in 2D its length [m].
///
/// Every cube of nodes is divided into D! simplices in which phi is linear, so that the surface is
/// a polygon in each; the error decreases as h^2.
template <class T, int D>
double surface_area(const LatticeView<T, D>& view, const Boundaries<D>& boundaries);

}  // namespace pliant::remeshed
