#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// How deep two shapes overlap [m]: the largest distance of a point inside both from both surfaces;
/// negative if they are separate. Probes `spacing` apart, in and around the intersection of their
/// boxes, are starts of a search for the maximum.
double overlap(const Shape& a, const Shape& b, double spacing, int dimension);

}  // namespace pliant
