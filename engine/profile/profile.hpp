#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/method/registry.hpp"
#include "engine/profile/frame_record.hpp"

/// Whether a case meets deadlines: frames of equal simulated time, each with a budget of wall time.
namespace pliant::profile {

/// The budget, the frames to measure, and the machine to use.
struct ProfileOptions {
  double budget = 1. / 60;         ///< wall time for a frame [s]
  double frame_seconds = 1. / 60;  ///< simulated time of a frame [s]
  double percentile = 99;          ///< share of the frames that must meet the budget [%]
  std::optional<int> frames;       ///< none: all of the case, at most `most_frames`
  std::optional<int> warm_up;      ///< frames before these; none: 10, but at most a tenth
  SolverOptions machine;
  std::filesystem::path trace = {};  ///< a Chrome trace; empty: none
  bool stop_when_missed = false;     ///< stop as soon as the budget cannot be met any more
};

inline constexpr int most_frames = 600;

/// What was run, on which machine, and the times.
struct Profile {
  Case settings;
  ProfileOptions options;
  std::int64_t particles = 0;
  std::vector<std::string> machine;  ///< lines for users
  double load_before = 0;            ///< load_average()
  int warm_up = 0;                   ///< frames
  std::vector<std::string> phases;
  std::vector<FrameRecord> frames;  ///< without those of the warm-up
  std::vector<StepTime> steps;      ///< of these frames
  double own_share = 0;  ///< ratio of the time of the measurement itself to that of the steps
  bool interrupted = false;
};

/// Called after each frame with the number of frames so far and in all, warm-up included.
using OnFrame = std::function<void(int done, int all)>;

/// Stops after a frame in which SIGINT, SIGTERM or SIGHUP arrives. Throws StepFailure, OutputError,
/// and InputError for a case that ends before the first frame.
Profile run_profile(const Case& settings, const ProfileOptions& options,
                    const MethodRegistry& methods, const OnFrame& on_frame = {});

}  // namespace pliant::profile
