#include "engine/profile/percentiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::profile {

namespace {

std::int64_t rank_of(std::int64_t count, double percent) {
  // Covers the rounding error of a product such as 0.99 * 600.
  constexpr double rounding = 1e-9;
  const double rank = std::ceil(percent / 100 * static_cast<double>(count) - rounding);
  return std::clamp(static_cast<std::int64_t>(rank), std::int64_t{1}, count);
}

}  // namespace

double percentile_of(std::vector<double> values, double percent) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = rank_of(static_cast<std::int64_t>(values.size()), percent);
  const auto at = values.begin() + (rank - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::int64_t most_missed(std::int64_t frames, double percent) {
  return frames - rank_of(frames, percent);
}

}  // namespace pliant::profile
