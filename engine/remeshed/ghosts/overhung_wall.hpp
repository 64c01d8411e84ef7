#pragma once

#include "engine/boundaries/walls.hpp"
#include "engine/remeshed/level_set/level_set.hpp"

namespace pliant::remeshed {

/// From a place on the free surface to a slip wall over which the surface leans there [m]; infinite
/// if there is none within the reach of a re-entrant corner. The body and its image in the wall
/// meet in such a corner, (RP.109). `outward` is the unit normal of the surface, h the spacing [m].
template <class T, int D>
double distance_to_overhung_wall(const Boundaries<D>& boundaries, const LevelSet<T, D>& level_set,
                                 double h, const Point<D>& place, const Point<D>& outward);

}  // namespace pliant::remeshed
