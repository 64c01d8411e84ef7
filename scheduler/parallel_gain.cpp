#include "scheduler/parallel_gain.hpp"

#include <algorithm>

namespace pliant::scheduler {

namespace {

// The first run on all workers may start them, and builds the flow graph.
constexpr int trials_alone = 4, all_trials = 8, trials_again = 500;  // [runs]
constexpr double long_time = 1e-3;                                   // [s]
constexpr double largest_share = 0.85;  // of the time alone that is worth the other cores

}  // namespace

bool ParallelGain::is_expected() const {
  if (run_ < all_trials) return run_ >= trials_alone;
  return together_ < largest_share * alone_;
}

void ParallelGain::record(double wall) {
  if (run_ == 0) {
    alone_ = wall;
    together_ = 0;
    if (wall > long_time) run_ = all_trials;
  } else if (run_ < trials_alone) {
    alone_ = std::min(alone_, wall);
  } else if (run_ < all_trials) {
    together_ = run_ == trials_alone ? wall : std::min(together_, wall);
  }
  if (++run_ == trials_again) run_ = 0;
}

}  // namespace pliant::scheduler
