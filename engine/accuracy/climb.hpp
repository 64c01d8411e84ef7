#pragma once

#include "engine/accuracy/ladders.hpp"
#include "engine/accuracy/record.hpp"

namespace pliant::accuracy {

struct ClimbOptions {
  std::filesystem::path folder;  ///< of the runs
  int threads = 1, repetitions = 1;
  bool resume = false;  ///< keep finished runs in the folder
  std::filesystem::path program = "/proc/self/exe";
};

/// Runs the ladders one run at a time, each in its own process: all series once, then all again. A
/// series ends when a run reaches the time limit. SIGINT, SIGTERM and SIGHUP end it early. Prints
/// progress to stderr. Throws OutputError, and InputError for a folder that already contains runs.
AccuracyRecord climb(const Ladders& ladders, const ClimbOptions& options);

}  // namespace pliant::accuracy
