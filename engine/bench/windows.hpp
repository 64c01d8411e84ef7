#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/bench/sample.hpp"

namespace pliant::bench {

/// For the remeshed method: whole periods of 20 steps (two remeshings, one reinitialisation of the
/// level set) that take about half a second, after one remeshing as a warm-up.
inline Window window_for(std::int64_t particles) {
  constexpr std::int64_t period = 20, most_steps = 1000, stages = 10'000'000;
  const std::int64_t periods = stages / (4 * period * particles);
  return {10, std::clamp(periods * period, period, most_steps), period};
}

/// About the same work, in steps with one evaluation each.
inline Window window_of_points(std::int64_t nodes) {
  constexpr std::int64_t least_steps = 5, node_steps = 5'000'000;
  const std::int64_t steps = std::max(node_steps / nodes, least_steps);
  return {5, steps, std::max(steps / 25, least_steps)};
}

}  // namespace pliant::bench
