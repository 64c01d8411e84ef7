#include "engine/simulation/oscillation.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/method/no_value.hpp"

namespace pliant {

namespace {

struct ZeroCrossing {
  double time;
  std::size_t after;  // first sample after the crossing
};

std::vector<ZeroCrossing> crossings(std::span<const double> time, std::span<const double> value) {
  std::vector<ZeroCrossing> found;
  std::size_t i = 1;
  while (i < value.size() && value[i - 1] == 0) ++i;  // a start from rest is not a crossing
  for (; i < value.size(); ++i) {
    if ((value[i - 1] < 0) == (value[i] < 0)) continue;
    const double part = value[i - 1] / (value[i - 1] - value[i]);
    found.push_back({time[i - 1] + part * (time[i] - time[i - 1]), i});
  }
  return found;
}

// Vertex of the parabola through three samples around the largest abs(value) in [first, last).
double extremum(std::span<const double> time, std::span<const double> value, std::size_t first,
                std::size_t last) {
  std::size_t top = first;
  for (std::size_t i = first; i < last; ++i) {
    if (std::abs(value[i]) > std::abs(value[top])) top = i;
  }
  if (top == 0 || top + 1 >= value.size()) return value[top];
  const double a = time[top - 1] - time[top], b = time[top + 1] - time[top];
  const double fa = (value[top - 1] - value[top]) / a, fb = (value[top + 1] - value[top]) / b;
  const double curvature = (fb - fa) / (b - a), slope = fa - curvature * a;
  return curvature == 0 ? value[top] : value[top] - slope * slope / (4 * curvature);
}

}  // namespace

double oscillation_period(std::span<const double> time, std::span<const double> value) {
  const std::vector<ZeroCrossing> zero = crossings(time, value);
  if (zero.size() < 2) return no_value;
  return 2 * (zero.back().time - zero.front().time) / static_cast<double>(zero.size() - 1);
}

double amplitude_ratio(std::span<const double> time, std::span<const double> value) {
  const std::vector<ZeroCrossing> zero = crossings(time, value);
  std::vector<double> extrema;
  // The interval before the first crossing counts if it starts at zero.
  if (!zero.empty() && value[0] == 0) extrema.push_back(extremum(time, value, 0, zero[0].after));
  for (std::size_t k = 0; k + 1 < zero.size(); ++k) {
    extrema.push_back(extremum(time, value, zero[k].after, zero[k + 1].after));
  }
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 2; k < extrema.size(); ++k, ++count) sum += extrema[k] / extrema[k - 2];
  return count == 0 ? no_value : sum / static_cast<double>(count);
}

}  // namespace pliant
