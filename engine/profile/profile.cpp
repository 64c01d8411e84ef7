#include "engine/profile/profile.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/bench/machine.hpp"
#include "engine/output/interrupt.hpp"
#include "engine/profile/percentiles.hpp"
#include "engine/profile/recorder.hpp"

namespace pliant::profile {

namespace {

struct Counts {
  int warm_up, frames;
};

// Loads and walls are only defined for the time of the case, so the default ends with it.
// Explicitly requested frames may go beyond.
Counts counts_of(const Case& settings, const ProfileOptions& options) {
  constexpr int usual_warm_up = 10;
  if (options.frames) return {options.warm_up.value_or(usual_warm_up), *options.frames};
  const double held = std::floor(settings.time.end / options.frame_seconds * (1 + 1e-9));
  const int all = static_cast<int>(std::min(held, 1e6));
  const int warm_up = options.warm_up.value_or(std::min(usual_warm_up, all / 10));
  if (all <= warm_up) {
    throw InputError(
        fmt::format("{}: the case ends at {} s, before its first frame of {:.4g} s does{}; give a "
                    "shorter --frame-time, or --frames to run beyond its end",
                    settings.name, settings.time.end, options.frame_seconds,
                    warm_up > 0 ? " after the warm-up" : ""));
  }
  return {warm_up, std::min(all - warm_up, most_frames)};
}

double wall_seconds(const std::vector<StepTime>& steps) {
  double sum = 0;
  for (const StepTime& step : steps) sum += step.wall_seconds;
  return sum;
}

}  // namespace

Profile run_profile(const Case& settings, const ProfileOptions& options,
                    const MethodRegistry& methods, const OnFrame& on_frame) {
  const Counts counts = counts_of(settings, options);
  const std::unique_ptr<Solver> solver = methods.make(settings, options.machine);
  std::optional<TraceWriter> trace;
  if (!options.trace.empty()) trace.emplace(options.trace, options.machine.threads);
  Profile profile{settings,
                  options,
                  solver->particles(),
                  bench::machine_description(),
                  load_average(),
                  counts.warm_up,
                  {},
                  {},
                  {},
                  0,
                  false};
  Recorder recorder(*solver, trace ? &*trace : nullptr);
  const Interrupt interrupt;
  std::size_t steps_of_warm_up = 0;
  std::int64_t missed = 0;
  const int all = counts.warm_up + counts.frames;
  profile.frames.reserve(static_cast<std::size_t>(counts.frames));
  for (int i = 1; i <= all && !interrupt.requested(); ++i) {
    FrameRecord frame = recorder.take_frame(i * options.frame_seconds);
    if (on_frame) on_frame(i, all);
    if (i <= counts.warm_up) {
      steps_of_warm_up = recorder.steps().size();
      continue;
    }
    if (frame.wall_seconds > options.budget) ++missed;
    profile.frames.push_back(std::move(frame));
    if (options.stop_when_missed && missed > most_missed(counts.frames, options.percentile)) break;
  }
  profile.interrupted = interrupt.requested();
  if (trace) trace->publish();
  profile.phases = recorder.phases();
  for (FrameRecord& frame : profile.frames) frame.phase_seconds.resize(profile.phases.size());
  profile.own_share = recorder.own_seconds() / std::max(wall_seconds(recorder.steps()), 1e-9);
  profile.steps.assign(recorder.steps().begin() + static_cast<std::ptrdiff_t>(steps_of_warm_up),
                       recorder.steps().end());
  profile.particles = solver->particles();
  return profile;
}

}  // namespace pliant::profile
