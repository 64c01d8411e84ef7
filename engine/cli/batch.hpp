#pragma once

#include "engine/batch/executor.hpp"
#include "engine/cli/actions.hpp"

namespace pliant::cli {

/// Common arguments of commands with many runs.
struct RunsArguments {
  std::optional<std::filesystem::path> folder;  ///< default: results/<name of the input file>
  std::string executor = "local";               ///< or "slurm"
  int workers = 0;                              ///< 0: limited by processors
  int threads = 1;                              ///< of each run
  bool resume = false, quiet = false;
};

struct BatchArguments : RunsArguments {
  std::filesystem::path sweep;
};

/// Throws InputError. On this machine, processors limit the number of runs at the same time.
batch::BatchOptions options_of(const RunsArguments& arguments, const std::string& name);

/// Runs a case with many values of its parameters.
ExitStatus batch(const BatchArguments& arguments);

struct TaskArguments {
  std::filesystem::path array;
  int index = 0;
};

/// Executes the runs of one task of a job array. Slurm calls it.
ExitStatus batch_task(const TaskArguments& arguments);

struct LedgerArguments {
  std::filesystem::path folder;  ///< of a batch
  bool json = false;
};

/// Prints the state of a batch, also while it runs.
ExitStatus batch_status(const LedgerArguments& arguments);
/// Prints parameters and measurements of all runs of a batch as CSV.
ExitStatus batch_export(const LedgerArguments& arguments);

}  // namespace pliant::cli
