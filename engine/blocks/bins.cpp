#include "engine/blocks/bins.hpp"

#include <cmath>
#include <functional>
#include <numeric>

namespace pliant {

namespace {

// Bins are wider by this share, so that rounding never puts two points one radius apart into bins
// that are not adjacent.
constexpr double widening = 1e-6;

}  // namespace

template <int D>
void Bins<D>::cover(const Position& lower, const Position& upper, const Position& period,
                    double radius, std::size_t most) {
  const double least_width = radius * (1 + widening);
  const double most_bins = static_cast<double>(std::max<std::size_t>(most, 1));
  period_ = period;
  lower_ = lower;
  Position length, count;
  for (int a = 0; a < D; ++a) {
    if (period[a] != 0) lower_[a] = 0;
    length[a] = period[a] != 0 ? period[a] : std::max(least_width, upper[a] - lower[a]);
    count[a] = std::clamp(std::floor(length[a] / least_width), 1.0, most_bins);
  }
  const auto all = [&] {
    return std::accumulate(count.begin(), count.end(), 1.0, std::multiplies<>());
  };
  while (all() > most_bins) {
    double& largest = *std::max_element(count.begin(), count.end());
    largest = std::ceil(largest / 2);
  }
  for (int a = 0; a < D; ++a) {
    count_[a] = static_cast<std::int32_t>(count[a]);
    per_size_[a] = count[a] / length[a];
    reach_[a] = static_cast<std::int32_t>(std::ceil(radius * (1 + widening / 2) * per_size_[a]));
  }
}

template <int D>
std::size_t Bins<D>::count() const {
  std::size_t count = 1;
  for (int a = 0; a < D; ++a) count *= count_[a];
  return count;
}

template class Bins<2>;
template class Bins<3>;

}  // namespace pliant
