#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/batch/ledger.hpp"
#include "engine/batch/sweep.hpp"

namespace pliant::batch {

struct BatchOptions {
  std::filesystem::path folder;
  int workers = 0;  ///< runs at once; 0: as many as there are processors for
  int threads = 1;  ///< of each run
  bool resume = false;
  bool quiet = false;
  std::filesystem::path program = "/proc/self/exe";
};

enum class BatchEnd { done, some_failed, interrupted };

/// Runs a sweep: each run is a process of its own in folder/runs/NAME, with its output in
/// folder/runs/NAME.log. Runs start while their estimates fit into the memory. SIGINT, SIGTERM and
/// SIGHUP end the runs with checkpoints. Throws OutputError, and InputError for a folder that holds
/// another batch, or one that is at work.
BatchEnd run_batch(const Sweep& sweep, const BatchOptions& options);

}  // namespace pliant::batch
