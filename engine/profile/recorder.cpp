#include "engine/profile/recorder.hpp"

#include <algorithm>
#include <chrono>

namespace pliant::profile {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Recorder::Recorder(Solver& solver, TraceWriter* trace) : solver_(solver), trace_(trace) {
  FrameRecord before;
  take_phases(before);  // set-up is not part of the first frame
  solver_.observe_graphs([this](const scheduler::StepGraph& graph) { observe(graph); });
}

Recorder::~Recorder() { solver_.observe_graphs({}); }

void Recorder::observe(const scheduler::StepGraph& graph) {
  const auto start = Clock::now();
  idle_.add(graph);
  graph_seconds_ += graph.record().wall_seconds;
  if (trace_ != nullptr) trace_->add(graph);
  own_seconds_ += seconds_since(start);
}

void Recorder::take_step(double until) {
  const double own = own_seconds_;
  const auto start = Clock::now();
  solver_.step(until - solver_.clock().time);
  const double seconds = seconds_since(start);
  steps_.push_back({solver_.clock().time, seconds - (own_seconds_ - own)});
  if (trace_ != nullptr) trace_->end_step(start, seconds, solver_.clock().time);
}

FrameRecord Recorder::take_frame(double until) {
  constexpr double rounding = 1e-12;
  graph_seconds_ = 0;
  FrameRecord frame;
  const std::size_t first = steps_.size();
  const std::int64_t remeshings = solver_.remeshings();
  const MachineCounters counters = MachineCounters::now();
  const auto start = Clock::now();
  while (solver_.clock().time < until * (1 - rounding)) take_step(until);
  const double with_recorder = seconds_since(start);
  frame.machine = MachineCounters::now() - counters;
  frame.load = load_average();
  frame.simulated_time = solver_.clock().time;
  for (std::size_t s = first; s < steps_.size(); ++s) frame.wall_seconds += steps_[s].wall_seconds;
  frame.steps = static_cast<std::int64_t>(steps_.size() - first);
  frame.remeshings = solver_.remeshings() - remeshings;
  const auto threads = static_cast<double>(solver_.workers().threads());
  const IdleTime idle = idle_.take();
  frame.scheduling_seconds = idle.scheduling / threads;
  frame.waiting_seconds = idle.waiting / threads;
  frame.serial_seconds = std::max(0.0, frame.wall_seconds - graph_seconds_);
  take_phases(frame);
  if (trace_ != nullptr) trace_->end_frame(start, with_recorder, frame.simulated_time);
  return frame;
}

void Recorder::take_phases(FrameRecord& frame) {
  const auto threads = static_cast<double>(solver_.workers().threads());
  frame.phase_seconds.assign(phases_.size(), 0);
  for (const auto& timer : solver_.step_totals().timers()) {
    const auto found = std::find(phases_.begin(), phases_.end(), timer.name);
    const auto phase = static_cast<std::size_t>(found - phases_.begin());
    if (found == phases_.end()) {
      phases_.push_back(timer.name);
      phase_totals_.push_back(0);
      frame.phase_seconds.push_back(0);
    }
    frame.phase_seconds[phase] = (timer.seconds - phase_totals_[phase]) / threads;
    phase_totals_[phase] = timer.seconds;
  }
}

}  // namespace pliant::profile
