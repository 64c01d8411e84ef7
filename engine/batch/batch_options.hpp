#pragma once

#include <filesystem>

namespace pliant::batch {

/// Where the runs of a batch are executed.
enum class Executor {
  local,  ///< processes of this machine
  slurm   ///< job arrays
};

struct BatchOptions {
  std::filesystem::path folder;
  Executor executor = Executor::local;
  int workers = 0;  ///< runs at the same time; 0: limited by processors
  int threads = 1;  ///< of each run
  bool resume = false;
  bool quiet = false;
  std::filesystem::path program = "/proc/self/exe";
};

enum class BatchEnd { done, some_failed, interrupted };

}  // namespace pliant::batch
