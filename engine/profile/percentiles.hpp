#pragma once

#include <cstdint>
#include <vector>

namespace pliant::profile {

/// The `percent`-th percentile by the nearest rank, which is one of the values; 100 gives the
/// largest. NaN without values.
double percentile_of(std::vector<double> values, double percent);

/// How many frames may miss a budget that is to be met at a percentile.
std::int64_t most_missed(std::int64_t frames, double percent);

}  // namespace pliant::profile
