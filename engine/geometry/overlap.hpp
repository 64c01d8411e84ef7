#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// How deep two shapes reach into each other [m]: the largest distance of a point from both
/// surfaces, inside both; negative where they stand apart. A search climbs to it from the best of
/// points `spacing` apart around where their boxes meet.
double overlap(const Shape& a, const Shape& b, double spacing, int dimension);

}  // namespace pliant
