#include "engine/simulation/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/method/no_value.hpp"

namespace pliant {

namespace {

using Samples = std::span<const double>;

/// A passage of the level about which a history oscillates.
struct Passage {
  double time;
  std::size_t after;  ///< first sample on the other side
};

struct Oscillation {
  double level;
  std::vector<Passage> crossings;
  bool starts_at_level;
};

/// Where the line between the samples i - 1 and i passes the level, if their signs differ.
double passage(Samples time, Samples value, double level, std::size_t i) {
  const double before = value[i - 1] - level, part = before / (value[i - 1] - value[i]);
  return time[i - 1] + part * (time[i] - time[i - 1]);
}

// Waves of higher modes around the level are not crossings of the oscillation: a crossing begins
// and ends a tenth of the amplitude away from it. A start from rest at the level is none.
Oscillation oscillation_about(double level, Samples time, Samples value) {
  constexpr double least = 0.1;
  double amplitude = 0;
  for (const double v : value) amplitude = std::max(amplitude, std::abs(v - level));
  const auto side = [&](double v) {
    return v - level > least * amplitude ? 1 : v - level < -least * amplitude ? -1 : 0;
  };
  Oscillation found = {level, {}, !value.empty() && side(value[0]) == 0};
  int last = 0;
  double first_passage = 0, last_passage = 0;
  std::size_t after = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (last != 0 && (value[i - 1] < level) != (value[i] < level)) {
      last_passage = passage(time, value, level, i);
      if (after == 0) first_passage = last_passage, after = i;
    }
    const int now = side(value[i]);
    if (now == 0) continue;
    if (now == -last) found.crossings.push_back({(first_passage + last_passage) / 2, after});
    last = now;
    after = 0;
  }
  return found;
}

// Vertex of the parabola through three samples around the one farthest from the level in
// [first, last), relative to the level.
double extremum(Samples time, Samples value, double level, std::size_t first, std::size_t last) {
  std::size_t top = first;
  for (std::size_t i = first; i < last; ++i) {
    if (std::abs(value[i] - level) > std::abs(value[top] - level)) top = i;
  }
  if (top == 0 || top + 1 >= value.size()) return value[top] - level;
  const double a = time[top - 1] - time[top], b = time[top + 1] - time[top];
  const double fa = (value[top - 1] - value[top]) / a, fb = (value[top + 1] - value[top]) / b;
  const double curvature = (fb - fa) / (b - a), slope = fa - curvature * a;
  return value[top] - level - (curvature == 0 ? 0 : slope * slope / (4 * curvature));
}

/// Largest deviations from the level between crossings. The swing before the first one counts if it
/// starts at the level.
std::vector<double> extrema(const Oscillation& of, Samples time, Samples value) {
  std::vector<double> found;
  const auto& [level, crossings, starts_at_level] = of;
  if (!crossings.empty() && starts_at_level) {
    found.push_back(extremum(time, value, level, 0, crossings[0].after));
  }
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
    found.push_back(extremum(time, value, level, crossings[k].after, crossings[k + 1].after));
  }
  return found;
}

// The deviations of a damped oscillation from its level are a geometric series, whose limit three
// of them give (Aitken). With fewer, the level is the middle of the largest and the smallest value.
Oscillation oscillation(Samples time, Samples value) {
  if (value.empty()) return {};
  const auto [least, most] = std::ranges::minmax(value);
  Oscillation about_middle = oscillation_about((least + most) / 2, time, value);
  const std::vector<double> swing = extrema(about_middle, time, value);
  if (swing.size() < 3) return about_middle;
  double sum = 0;
  for (std::size_t k = 2; k < swing.size(); ++k) {
    const double a = swing[k - 2], b = swing[k - 1], c = swing[k];
    sum += (a * c - b * b) / (a + c - 2 * b);
  }
  return oscillation_about(about_middle.level + sum / static_cast<double>(swing.size() - 2), time,
                           value);
}

}  // namespace

double oscillation_period(std::span<const double> time, std::span<const double> value) {
  const std::vector<Passage> crossings = oscillation(time, value).crossings;
  if (crossings.size() < 2) return no_value;
  return 2 * (crossings.back().time - crossings.front().time) /
         static_cast<double>(crossings.size() - 1);
}

double amplitude_ratio(std::span<const double> time, std::span<const double> value) {
  const std::vector<double> swing = extrema(oscillation(time, value), time, value);
  if (swing.size() < 3) return no_value;
  double sum = 0;
  for (std::size_t k = 2; k < swing.size(); ++k) sum += swing[k] / swing[k - 2];
  return sum / static_cast<double>(swing.size() - 2);
}

}  // namespace pliant
