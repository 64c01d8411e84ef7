#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/profile/percentiles.hpp"
#include "engine/profile/profile.hpp"

/// Evaluates the times of frames against a budget.
namespace pliant::profile {

/// Mean, percentiles and maximum of times [s].
struct Distribution {
  double mean = 0, p50 = 0, p95 = 0, p99 = 0, p999 = 0, most = 0;
};

/// A part of a frame: a phase, or "scheduling", "waiting" or "serial part".
struct Part {
  std::string name;
  double share = 0;     ///< of the time of all frames
  double median = 0;    ///< over the frames [s]
  double in_worst = 0;  ///< mean of the worst frames [s]
  double excess() const { return in_worst - median; }
};

/// Whether the budget is met, and where the time is spent.
struct Verdict {
  bool held = false;
  double at_percentile = 0;  ///< frame time [s]
  std::int64_t missed = 0, longest_streak = 0;
  double real_time_factor = 0;     ///< ratio of simulated time to wall time
  Distribution frames, steps;      ///< [s]
  std::vector<std::size_t> worst;  ///< at most ten frames, in descending order of time
  std::vector<Part> parts;         ///< in descending order of share
  std::size_t to_blame = 0;        ///< the part with the largest excess
};

/// The parts of a frame in the order of the step; scheduling, waiting and serial part come last
/// [s].
std::vector<double> parts_of(const FrameRecord& frame);
std::vector<std::string> names_of_parts(const std::vector<std::string>& phases);

/// Requires at least one frame.
Verdict judge(const Profile& profile);

}  // namespace pliant::profile
