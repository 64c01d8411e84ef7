#include "scheduler/parallel_gain.hpp"

#include <algorithm>

namespace pliant::scheduler {

namespace {

// The first run on all workers may start them, and builds the flow graph.
constexpr int trials_alone = 4, all_trials = 12;  // [runs]
constexpr int first_stretch = 500, longest_stretch = 100'000;
constexpr double long_time = 1e-3;      // [s]
constexpr double largest_share = 0.85;  // of the time alone that is worth the other cores
// Runs in a row that take that many times as long as in the trials ask for new ones. Single ones
// are those of a processor that does something else.
constexpr int enough_longer_runs = 4;
constexpr double growth = 2;

}  // namespace

bool ParallelGain::is_expected() const {
  return run_ < all_trials ? run_ >= trials_alone : is_chosen_;
}

void ParallelGain::record(double wall) {
  double& shortest = run_ < trials_alone ? alone_ : together_;
  const bool is_first = run_ == 0 || run_ == trials_alone;
  if (run_ < all_trials) shortest = is_first ? wall : std::min(shortest, wall);
  const bool is_longer = run_ >= all_trials && !is_chosen_ && wall > growth * alone_;
  longer_runs_ = is_longer ? longer_runs_ + 1 : 0;
  ++run_;
  if (run_ == 1 && alone_ > long_time) {
    choose(true);
  } else if (run_ == all_trials) {
    choose(together_ < largest_share * alone_);
  } else if (run_ >= stretch_ + all_trials || longer_runs_ == enough_longer_runs) {
    run_ = 0;
  }
}

void ParallelGain::choose(bool all_workers) {
  stretch_ = all_workers == is_chosen_ ? std::clamp(2 * stretch_, first_stretch, longest_stretch)
                                       : first_stretch;
  is_chosen_ = all_workers;
  run_ = all_trials;
}

}  // namespace pliant::scheduler
