#pragma once

#include <filesystem>

namespace pliant::batch {

/// What executes the runs of a batch.
enum class Executor {
  local,  ///< processes of this machine
  slurm   ///< job arrays
};

/// How a batch is run.
struct BatchOptions {
  std::filesystem::path folder;
  Executor executor = Executor::local;
  int workers = 0;  ///< runs at once; 0: as many as there are processors for
  int threads = 1;  ///< of each run
  bool resume = false;
  bool quiet = false;
  std::filesystem::path program = "/proc/self/exe";
};

enum class BatchEnd { done, some_failed, interrupted };

}  // namespace pliant::batch
