#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/batch/batch_options.hpp"
#include "engine/batch/ledger.hpp"
#include "engine/batch/progress_line.hpp"
#include "engine/batch/sweep.hpp"
#include "engine/batch/waiting.hpp"

namespace pliant::batch {

/// What a batch has to do, whichever executor does it.
class Work {
 public:
  Work(const Sweep& sweep, const BatchOptions& options, Ledger& ledger);

  std::deque<Waiting> waiting;
  ProgressLine progress;

  std::filesystem::path folder_of(const std::string& run) const;
  /// The program with its arguments, without the folder of the results.
  std::vector<std::string> command_of(const Assignment& parameters) const;
  std::vector<std::string> settings_of(const Assignment& parameters) const;

  /// Whether the run needs no process: it ended unseen, or its case is wrong. Estimates what it
  /// needs where that is not known yet.
  bool is_settled(Waiting& run);
  /// Writes the end of an attempt into the ledger, and counts it.
  void end(const std::string& run, RunStatus status, const Outcome& outcome);
  /// Does so with an attempt that another process has made.
  void put(const RunRow& row);

  /// Itself, or a path that holds on other machines too.
  const std::filesystem::path& program() const { return program_; }
  const Sweep& sweep() const { return sweep_; }
  const BatchOptions& options() const { return options_; }
  Ledger& ledger() { return ledger_; }
  BatchEnd how(bool interrupted) const;

 private:
  const Sweep& sweep_;
  const BatchOptions& options_;
  Ledger& ledger_;
  std::filesystem::path program_;

  void count(RunStatus status);
};

/// Runs them as processes on this machine.
BatchEnd run_here(Work& work);

/// Runs them as job arrays of Slurm. Throws InputError where there is no Slurm, or where it refuses
/// them.
BatchEnd run_on_slurm(Work& work);

/// Throws InputError where Slurm has tasks of the batch in this folder that wait or run.
void refuse_tasks_of_slurm(const std::filesystem::path& folder);

}  // namespace pliant::batch
