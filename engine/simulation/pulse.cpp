#include "engine/simulation/pulse.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/method/no_value.hpp"

namespace pliant {

namespace {

constexpr double rounding = 1e-9;  // relative to the duration: sample times are sums of many steps

// Integral over the samples (first, last]; the first of them counts only from `from` on.
double integral(std::span<const double> time, std::span<const double> value, std::size_t first,
                std::size_t last, double from) {
  double sum = value[first + 1] * (time[first + 1] - from);
  for (std::size_t i = first + 2; i <= last; ++i) sum += value[i] * (time[i] - time[i - 1]);
  return sum;
}

}  // namespace

double peak_moving_average(std::span<const double> time, std::span<const double> value,
                           double duration) {
  double largest = no_value;
  std::size_t first = 0;
  for (std::size_t last = 1; last < time.size(); ++last) {
    const double from = std::max(time[last] - duration, time[0]);
    if (time[last] - time[0] < duration * (1 - rounding)) continue;
    while (time[first + 1] <= from) ++first;
    const double mean = integral(time, value, first, last, from) / duration;
    if (std::isnan(largest) || std::abs(mean) > std::abs(largest)) largest = mean;
  }
  return largest;
}

double last_time_above(std::span<const double> time, std::span<const double> value,
                       double fraction) {
  double largest = 0, last = no_value;
  for (const double v : value) largest = std::max(largest, std::abs(v));
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::abs(value[i]) > fraction * largest) last = time[i];
  }
  return last;
}

}  // namespace pliant
