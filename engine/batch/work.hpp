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

/// The work of a batch, for any executor.
class Work {
 public:
  Work(const Sweep& sweep, const BatchOptions& options, Ledger& ledger);

  std::deque<Waiting> waiting;
  ProgressLine progress;

  std::filesystem::path folder_of(const std::string& run) const;
  /// The program with its arguments, without the folder of the results.
  std::vector<std::string> command_of(const Assignment& parameters) const;
  std::vector<std::string> settings_of(const Assignment& parameters) const;

  /// Whether the run needs no process: it has already ended, or its case is wrong. Estimates the
  /// needs of the run if they are not known yet.
  bool is_settled(Waiting& run);
  /// Writes the end of an attempt to the ledger, and counts it.
  void end(const std::string& run, RunStatus status, const Outcome& outcome);
  /// The same for an attempt made by another process.
  void put(const RunRow& row);

  /// The path of this program, also valid on other machines if necessary.
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

/// Executes the runs as processes on this machine.
BatchEnd run_here(Work& work);

/// Executes the runs as job arrays of Slurm. Throws InputError if there is no Slurm, or if it
/// refuses them.
BatchEnd run_on_slurm(Work& work);

/// Throws InputError if Slurm has waiting or running tasks of the batch in this folder.
void refuse_tasks_of_slurm(const std::filesystem::path& folder);

}  // namespace pliant::batch
