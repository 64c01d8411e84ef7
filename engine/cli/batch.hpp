#pragma once

#include "engine/cli/verbs.hpp"

namespace pliant::cli {

/// What commands that make many runs have in common.
struct RunsArguments {
  std::optional<std::filesystem::path> folder;  ///< default: results/<name of the input file>
  int workers = 0;                              ///< 0: as many as there are processors for
  int threads = 1;                              ///< of each run
  bool resume = false, quiet = false;
};

struct BatchArguments : RunsArguments {
  std::filesystem::path sweep;
};

/// Runs at once, of so many threads each, where the user asks for `workers`; 0: as many as there
/// are processors for. Throws InputError.
int workers_of(int workers, int threads);

/// Runs a case with many values of its parameters.
ExitStatus batch(const BatchArguments& arguments);

struct LedgerArguments {
  std::filesystem::path folder;  ///< of a batch
  bool json = false;
};

/// Says how far a batch is, also while it runs.
ExitStatus batch_status(const LedgerArguments& arguments);
/// Prints parameters and measurements of all runs of a batch as CSV.
ExitStatus batch_export(const LedgerArguments& arguments);

}  // namespace pliant::cli
