#pragma once

#include <string>
#include <vector>

#include "engine/method/solver.hpp"
#include "engine/profile/frame_record.hpp"
#include "engine/profile/idle_time.hpp"
#include "engine/profile/trace.hpp"

namespace pliant::profile {

/// Advances a solver frame by frame and measures it. Its own work between graphs is not included in
/// its times.
class Recorder {
 public:
  /// `trace` may be nullptr. Both must outlive the recorder.
  Recorder(Solver& solver, TraceWriter* trace);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();

  /// Steps until the time is exactly `until` [s]. Throws StepFailure.
  FrameRecord take_frame(double until);

  /// Names of the phases so far; frames taken earlier may have fewer.
  const std::vector<std::string>& phases() const { return phases_; }
  const std::vector<StepTime>& steps() const { return steps_; }
  /// Time that the recorder itself used within steps [s].
  double own_seconds() const { return own_seconds_; }

 private:
  void observe(const scheduler::StepGraph& graph);
  void take_step(double until);
  void take_phases(FrameRecord& frame);

  Solver& solver_;
  TraceWriter* trace_;
  std::vector<std::string> phases_;
  std::vector<double> phase_totals_;  // [phase] of the solver at the last frame
  std::vector<StepTime> steps_;
  IdleTimeSplitter idle_;     // for the present frame
  double graph_seconds_ = 0;  // for the present frame
  double own_seconds_ = 0;
};

}  // namespace pliant::profile
