#pragma once

#include <cstdint>

#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/method/solver.hpp"
#include "engine/simulation/schedule.hpp"

namespace pliant {

/// When cases without an interval of their own are sampled, at ends of steps: a hundred times if
/// measurements depend on samples, but not in successive steps, as a sample may cost as much as
/// several of them; otherwise when measuring is due.
class DefaultSamples {
 public:
  explicit DefaultSamples(const Case& settings)
      : is_needed_(settings.output.measure_every == 0),
        by_time_(depends_on_samples(settings)),
        schedule_(settings.time.end / samples) {}

  bool due(const Solver& solver) {
    if (!is_needed_) return false;
    if (!by_time_) return solver.is_measuring_due();
    return solver.clock().step % steps_apart == 0 && schedule_.passed(solver.clock().time);
  }
  /// Continues after a sample at `time` [s].
  void restore(double time) { schedule_.passed(time); }

 private:
  static constexpr int samples = 100;
  static constexpr std::int64_t steps_apart = 8;

  bool is_needed_, by_time_;
  Schedule schedule_;
};

}  // namespace pliant
