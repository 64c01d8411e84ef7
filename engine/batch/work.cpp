#include "engine/batch/work.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <map>

#include "engine/batch/outcome.hpp"
#include "engine/batch/slurm/attempt.hpp"
#include "engine/case/reading/read_case.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::batch {

Work::Work(const Sweep& sweep, const BatchOptions& options, Ledger& ledger)
    : progress(options.quiet),
      sweep_(sweep),
      options_(options),
      ledger_(ledger),
      program_(options.executor == Executor::slurm ? std::filesystem::canonical(options.program)
                                                   : options.program) {
  std::map<std::string, RunRow> known;
  for (RunRow& row : ledger_.rows()) known.emplace(row.name, row);
  for (const Assignment& run : sweep.runs) {
    RunRow& row = known.at(name_of(run));
    ++progress.all;
    // Tasks of Slurm continue after this program is killed.
    const auto attempt = slurm::read_attempt(folder_of(row.name));
    if (row.status != RunStatus::done && attempt && attempt->row.attempts >= row.attempts) {
      row = attempt->row;
      ledger_.put(row);
    }
    if (row.status == RunStatus::done) {
      ++progress.done;
    } else {
      waiting.push_back({run, row.name, 1 + sweep.retries, row.attempts});
    }
  }
  ledger_.reset_running();
}

std::filesystem::path Work::folder_of(const std::string& run) const {
  return options_.folder / "runs" / run;
}

std::vector<std::string> Work::settings_of(const Assignment& parameters) const {
  std::vector<std::string> settings = sweep_.settings;
  for (const auto& [key, value] : parameters) settings.push_back(key + "=" + value);
  return settings;
}

std::vector<std::string> Work::command_of(const Assignment& parameters) const {
  std::vector<std::string> command = {
      program_.string(), "run",       sweep_.case_file.string(),
      "--quiet",         "--threads", fmt::format("{}", options_.threads)};
  for (const std::string& setting : settings_of(parameters)) {
    command.insert(command.end(), {"--set", setting});
  }
  return command;
}

bool Work::is_settled(Waiting& run) {
  Outcome outcome;
  if (run.attempts > 0 && read_summary(folder_of(run.name), outcome)) {
    outcome.exit_status = 0;
    end(run.name, RunStatus::done, outcome);
    return true;
  }
  if (run.bytes > 0) return false;
  try {
    const Estimate size = estimate(read_case(sweep_.case_file, settings_of(run.parameters)));
    run.bytes = size.bytes;
    run.steps = static_cast<double>(size.particles) * static_cast<double>(size.steps + size.looks);
    return false;
  } catch (const InputError& error) {
    outcome.exit_status = 2;
    outcome.message = error.what();
    ledger_.start(run.name);
    end(run.name, RunStatus::failed, outcome);
    return true;
  }
}

void Work::end(const std::string& run, RunStatus status, const Outcome& outcome) {
  ledger_.end(run, status, outcome);
  count(status);
}

void Work::put(const RunRow& row) {
  ledger_.put(row);
  count(row.status);
  if (row.status == RunStatus::done) progress.add_run(row.outcome.wall_seconds);
}

void Work::count(RunStatus status) {
  progress.done += status == RunStatus::done ? 1 : 0;
  progress.failed += status == RunStatus::failed ? 1 : 0;
}

BatchEnd Work::how(bool interrupted) const {
  if (interrupted) return BatchEnd::interrupted;
  return progress.failed > 0 ? BatchEnd::some_failed : BatchEnd::done;
}

}  // namespace pliant::batch
