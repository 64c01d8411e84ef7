#pragma once

#include <array>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/lattice/lattice.hpp"

/// Measurements of the free surface, from its segments (2D) or triangles (3D).
namespace pliant::undeformed {

/// Present corners of the pieces of a free surface [m], ordered as seen from outside.
template <int D>
using FreeSurface = std::vector<std::array<Point<D>, D>>;

/// An `extent` at the time `t` [m]; NaN where no corner counts.
template <int D>
double extent(const FreeSurface<D>& surface, const MeasurementCase& m, double t);

/// A `surface_distance` [m], to the last piece along the line; NaN if the line meets none.
template <int D>
double surface_distance(const FreeSurface<D>& surface, const MeasurementCase& m);

/// A `mean_radius` [m]; NaN if a direction meets no piece.
template <int D>
double mean_radius(const FreeSurface<D>& surface, const MeasurementCase& m);

/// A `surface_area` [m^(D-1)].
template <int D>
double surface_area(const FreeSurface<D>& surface);

}  // namespace pliant::undeformed
