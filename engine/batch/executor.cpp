#include "engine/batch/executor.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include "engine/batch/child.hpp"
#include "engine/batch/work.hpp"
#include "engine/case/reading/read_case.hpp"

namespace pliant::batch {

namespace {

/// What must not change when a batch is resumed.
std::string identity_of(const Sweep& sweep) {
  std::string text = case_text(sweep.case_file);
  for (const std::string& setting : sweep.settings) text += "\n--set " + setting;
  return text;
}

void prepare(Ledger& ledger, const Sweep& sweep, const std::filesystem::path& folder) {
  const std::string identity = identity_of(sweep);
  const auto before = ledger.get("case");
  if (before && *before != identity) {
    throw InputError(
        fmt::format("{}: the base case or the settings of all runs have changed since the batch "
                    "began; restore them, or give another --out",
                    folder.string()));
  }
  ledger.set("case", identity);
  ledger.set("name", sweep.name);
  ledger.add(sweep.runs);
}

}  // namespace

BatchEnd run_batch(const Sweep& sweep, const BatchOptions& options) {
  const std::filesystem::path& folder = options.folder;
  if (!options.resume && (Ledger::exists(folder) || std::filesystem::exists(folder / "runs"))) {
    throw InputError(fmt::format(
        "{}: holds a batch; continue it with --resume, or give another --out", folder.string()));
  }
  std::filesystem::create_directories(folder / "runs");
  if (!lock_for_life(folder / "batch.lock")) {
    throw InputError(fmt::format("{}: this batch is at work in another process; wait for its end",
                                 folder.string()));
  }
  if (options.executor == Executor::local) refuse_tasks_of_slurm(folder);
  Ledger ledger(folder, Ledger::Use::write);
  prepare(ledger, sweep, folder);
  Work work(sweep, options, ledger);
  return options.executor == Executor::slurm ? run_on_slurm(work) : run_here(work);
}

}  // namespace pliant::batch
