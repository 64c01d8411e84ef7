#include "engine/cli/batch.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "engine/batch/executor.hpp"
#include "engine/batch/listing.hpp"
#include "engine/batch/slurm/worker.hpp"
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

batch::BatchOptions options_of(const RunsArguments& arguments, const std::string& name) {
  if (arguments.workers < 0) {
    throw InputError(fmt::format("--workers {}: give a positive number", arguments.workers));
  }
  batch::BatchOptions options;
  options.folder = arguments.folder.value_or(std::filesystem::path("results") / name);
  options.executor =
      arguments.executor == "slurm" ? batch::Executor::slurm : batch::Executor::local;
  options.threads = solver_options(arguments.threads, "").threads;
  options.workers = arguments.workers;
  if (options.executor == batch::Executor::local) {
    const int most = std::max(1, solver_options(0, "").threads / options.threads);
    options.workers = arguments.workers == 0 ? most : std::min(arguments.workers, most);
  }
  options.resume = arguments.resume;
  options.quiet = arguments.quiet;
  return options;
}

ExitStatus batch(const BatchArguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  const batch::Sweep sweep = batch::read_sweep(arguments.sweep);
  const batch::BatchOptions options = options_of(arguments, sweep.name);
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

ExitStatus batch_task(const TaskArguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  return batch::slurm::work_on(arguments.array, arguments.index) ? ExitStatus::done
                                                                 : ExitStatus::interrupted;
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
