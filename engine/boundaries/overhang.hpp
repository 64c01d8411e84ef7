#pragma once

#include <optional>

#include "engine/boundaries/walls.hpp"
#include "engine/geometry/shape.hpp"
#include "engine/lattice/column.hpp"

/// Bodies that overhang a wall that holds them: the free surface leaves the wall at an obtuse
/// angle, as that of a ball of which a wall holds a cap.
///
///                     free surface /
///                  body           /  not held
///          ----------------------/ - - - - - - wall
///                               rim
namespace pliant {

/// Where what a wall holds ends, seen from a point of the wall.
template <int D>
struct WayToRim {
  Column<D> foot;  ///< the point of the wall [m]
  Column<D> way;   ///< from there to the rim, along the wall [m]
  bool is_beyond;  ///< the foot is not in the body
};

/// From the point of the wall nearest to `x` to the rim of an overhang. Nothing where the body does
/// not overhang, and where the foot is deeper in the body than `farthest` [m].
template <int D>
std::optional<WayToRim<D>> way_to_rim(const Shape& body, const Wall<D>& wall, const Point<D>& x,
                                      double farthest);

/// Whether the foot of `x` is farther beyond the rim of an overhang than `by` [m].
template <int D>
bool is_beyond_rim(const Shape& body, const Wall<D>& wall, const Point<D>& x, double by);

extern template std::optional<WayToRim<2>> way_to_rim<2>(const Shape&, const Wall<2>&,
                                                         const Point<2>&, double);
extern template std::optional<WayToRim<3>> way_to_rim<3>(const Shape&, const Wall<3>&,
                                                         const Point<3>&, double);
extern template bool is_beyond_rim<2>(const Shape&, const Wall<2>&, const Point<2>&, double);
extern template bool is_beyond_rim<3>(const Shape&, const Wall<3>&, const Point<3>&, double);

}  // namespace pliant
