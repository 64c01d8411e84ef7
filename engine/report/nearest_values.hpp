#pragma once

#include <vector>

#include "engine/report/frame_points.hpp"

namespace pliant::report {

/// Sets the scalars `scalars` of `points` to means over the nearest particles, weighted by the
/// inverse squared distance.
void take_nearest_values(const FramePoints& particles, const std::vector<std::size_t>& scalars,
                         FramePoints& points);

}  // namespace pliant::report
