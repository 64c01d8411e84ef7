#pragma once

#include <cstdint>
#include <vector>

namespace pliant::profile {

/// The `percent`-th percentile by the nearest rank, a value that occurred; 100 is the largest. NaN
/// of no values.
double percentile_of(std::vector<double> values, double percent);

/// How many of so many frames may miss a budget that is held at a percentile.
std::int64_t most_missed(std::int64_t frames, double percent);

}  // namespace pliant::profile
