#pragma once

#include "engine/geometry/shape.hpp"

namespace pliant {

/// How deep two shapes reach into each other [m]: the largest distance of a point from both
/// surfaces, inside both; negative where they stand apart. Looked for on points `spacing` apart
/// around where their boxes meet, so that it is good to about that.
double overlap(const Shape& a, const Shape& b, double spacing, int dimension);

}  // namespace pliant
