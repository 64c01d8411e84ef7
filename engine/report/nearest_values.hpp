#pragma once

#include <vector>

#include "engine/report/frame_points.hpp"

namespace pliant::report {

/// Fills the numbers `scalars` of `points` with means of those of the nearest particles, weighted
/// by the inverse square of the distance.
void take_nearest_values(const FramePoints& particles, const std::vector<std::size_t>& scalars,
                         FramePoints& points);

}  // namespace pliant::report
