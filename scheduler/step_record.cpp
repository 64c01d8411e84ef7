#include "scheduler/step_record.hpp"

#include <algorithm>
#include <numeric>

namespace pliant::scheduler {

namespace {

double idle_share_of(std::span<const double> busy_seconds, double wall_seconds) {
  const double available = static_cast<double>(busy_seconds.size()) * wall_seconds;
  if (available <= 0) return 0;
  return 1 - std::accumulate(busy_seconds.begin(), busy_seconds.end(), 0.0) / available;
}

}  // namespace

double StepRecord::idle_share() const { return idle_share_of(worker_busy_seconds, wall_seconds); }

double StepTotals::idle_share() const { return idle_share_of(worker_busy_seconds_, wall_seconds_); }

void StepTotals::add(const StepRecord& record, std::span<const std::string> timer_names) {
  ++steps_;
  wall_seconds_ += record.wall_seconds;
  for (std::size_t i = 0; i < timer_names.size(); ++i) {
    // Names usually keep their positions from step to step.
    auto timer = timers_.begin() + static_cast<std::ptrdiff_t>(std::min(i, timers_.size()));
    if (timer == timers_.end() || timer->name != timer_names[i])
      timer = std::find_if(timers_.begin(), timers_.end(),
                           [&](const Timer& t) { return t.name == timer_names[i]; });
    if (timer == timers_.end()) timer = timers_.insert(timer, {timer_names[i], 0});
    timer->seconds += record.phase_seconds[i];
  }
  if (worker_busy_seconds_.size() < record.worker_busy_seconds.size())
    worker_busy_seconds_.resize(record.worker_busy_seconds.size());
  for (std::size_t w = 0; w < record.worker_busy_seconds.size(); ++w)
    worker_busy_seconds_[w] += record.worker_busy_seconds[w];
}

}  // namespace pliant::scheduler
