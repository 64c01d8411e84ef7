#include "engine/cli/batch.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "engine/batch/executor.hpp"
#include "engine/batch/listing.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

std::vector<batch::RunRow> rows_of(const std::filesystem::path& folder) {
  if (!batch::Ledger::exists(folder)) {
    throw InputError(fmt::format("{}: holds no batch; give the folder that `pliant batch` wrote to",
                                 folder.string()));
  }
  return batch::Ledger(folder, batch::Ledger::Use::read).rows();
}

}  // namespace

int workers_of(int workers, int threads) {
  const int most = std::max(1, solver_options(0, "").threads / threads);
  if (workers < 0) {
    throw InputError(fmt::format("--workers {}: give a positive number", workers));
  }
  return workers == 0 ? most : std::min(workers, most);
}

ExitStatus batch(const BatchArguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  const batch::Sweep sweep = batch::read_sweep(arguments.sweep);
  batch::BatchOptions options;
  options.folder = arguments.folder.value_or(std::filesystem::path("results") / sweep.name);
  options.threads = solver_options(arguments.threads, "").threads;
  options.workers = workers_of(arguments.workers, options.threads);
  options.resume = arguments.resume;
  options.quiet = arguments.quiet;
  const batch::BatchEnd end = run_batch(sweep, options);
  if (!options.quiet) {
    std::fputs(status_text(rows_of(options.folder)).c_str(), stderr);
  }
  switch (end) {
    case batch::BatchEnd::done:
      return ExitStatus::done;
    case batch::BatchEnd::some_failed:
      return ExitStatus::run_failed;
    case batch::BatchEnd::interrupted:
      break;
  }
  return ExitStatus::interrupted;
}

ExitStatus batch_status(const LedgerArguments& arguments) {
  const auto rows = rows_of(arguments.folder);
  fmt::print("{}", arguments.json ? status_json(rows) : status_text(rows));
  return ExitStatus::done;
}

ExitStatus batch_export(const LedgerArguments& arguments) {
  fmt::print("{}", csv_of(rows_of(arguments.folder)));
  return ExitStatus::done;
}

}  // namespace pliant::cli
