#include "engine/batch/executor.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <deque>
#include <map>

#include "engine/batch/child.hpp"
#include "engine/batch/job.hpp"
#include "engine/batch/outcome.hpp"
#include "engine/batch/progress_line.hpp"
#include "engine/case/read_case.hpp"
#include "engine/output/interrupt.hpp"
#include "engine/simulation/estimate.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::batch {

namespace {

constexpr timespec longest_sleep = {0, 100'000'000};

/// A run that is not done.
struct Waiting {
  Assignment parameters;
  std::string name;
  int attempts_left;
  bool has_begun;     ///< in this batch or in an earlier one
  std::size_t bytes;  ///< estimate; 0: not known yet
};

class Executor {
 public:
  Executor(const Sweep& sweep, const BatchOptions& options, Ledger& ledger)
      : sweep_(sweep),
        options_(options),
        ledger_(ledger),
        memory_(available_memory()),
        progress_(options.quiet) {
    ledger_.reset_running();
    std::map<std::string, RunRow> known;
    for (RunRow& row : ledger_.rows()) known.emplace(row.name, row);
    for (const Assignment& run : sweep.runs) {
      const RunRow& row = known.at(name_of(run));
      ++progress_.all;
      if (row.status == RunStatus::done) {
        ++progress_.done;
        continue;
      }
      waiting_.push_back({run, row.name, 1 + sweep.retries, row.attempts > 0, 0});
    }
  }

  BatchEnd operator()() {
    // Signals that come while none is waited for stay pending.
    sigset_t ended;
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    sigprocmask(SIG_BLOCK, &ended, nullptr);
    const Interrupt interrupt;
    while (!jobs_.empty() || (!waiting_.empty() && !interrupt.requested())) {
      if (interrupt.requested()) {
        for (Job& job : jobs_) job.stop();
      } else {
        start_jobs();
      }
      if (!jobs_.empty() || !waiting_.empty()) sigtimedwait(&ended, nullptr, &longest_sleep);
      for (Job& job : jobs_) job.keep_limit(sweep_.time_limit);
      collect(interrupt.requested());
      progress_.show(jobs_.size(), options_.workers);
    }
    progress_.finish();
    if (interrupt.requested()) return BatchEnd::interrupted;
    return progress_.failed > 0 ? BatchEnd::some_failed : BatchEnd::done;
  }

 private:
  std::filesystem::path folder_of(const std::string& run) const {
    return options_.folder / "runs" / run;
  }

  // A run whose process still ends after the batch was killed has its turn later.
  void start_jobs() {
    for (std::size_t tries = waiting_.size();
         tries > 0 && static_cast<int>(jobs_.size()) < options_.workers; --tries) {
      Waiting run = waiting_.front();
      waiting_.pop_front();
      if (is_locked(Job::lock_of(folder_of(run.name)))) {
        waiting_.push_back(run);
      } else if (!is_settled(run) && !start(run)) {
        waiting_.push_front(run);
        return;
      }
    }
  }

  /// Whether the run needs no process: it ended unseen, or its case is wrong.
  bool is_settled(Waiting& run) {
    Outcome outcome;
    if (run.has_begun && read_summary(folder_of(run.name), outcome)) {
      outcome.exit_status = 0;
      ledger_.end(run.name, RunStatus::done, outcome);
      ++progress_.done;
      return true;
    }
    if (run.bytes > 0) return false;
    try {
      run.bytes = estimate(read_case(sweep_.case_file, settings_of(run.parameters))).bytes;
      return false;
    } catch (const InputError& error) {
      outcome.exit_status = 2;
      outcome.message = error.what();
      ledger_.start(run.name);
      ledger_.end(run.name, RunStatus::failed, outcome);
      ++progress_.failed;
      return true;
    }
  }

  /// False where the memory does not suffice before another run ends.
  bool start(const Waiting& run) {
    std::size_t used = 0;
    for (const Job& job : jobs_) used += job.bytes();
    if (!jobs_.empty() && used + run.bytes > memory_) return false;
    ledger_.start(run.name);
    jobs_.emplace_back(run.parameters, run.attempts_left, run.bytes, folder_of(run.name),
                       command_of(run.parameters));
    return true;
  }

  std::vector<std::string> settings_of(const Assignment& parameters) const {
    std::vector<std::string> settings = sweep_.settings;
    for (const auto& [key, value] : parameters) settings.push_back(key + "=" + value);
    return settings;
  }

  std::vector<std::string> command_of(const Assignment& parameters) const {
    std::vector<std::string> command = {options_.program.string(),
                                        "run",
                                        sweep_.case_file.string(),
                                        "--quiet",
                                        "--threads",
                                        fmt::format("{}", options_.threads)};
    for (const std::string& setting : settings_of(parameters)) {
      command.insert(command.end(), {"--set", setting});
    }
    return command;
  }

  void collect(bool interrupted) {
    for (auto job = jobs_.begin(); job != jobs_.end();) {
      std::optional<Outcome> outcome = job->outcome();
      if (!outcome) {
        ++job;
        continue;
      }
      record(*job, *outcome, interrupted);
      job = jobs_.erase(job);
    }
  }

  void record(const Job& job, const Outcome& outcome, bool interrupted) {
    if (outcome.exit_status == 0) {
      ledger_.end(job.name(), RunStatus::done, outcome);
      ++progress_.done;
      progress_.add_run(outcome.wall_seconds);
      return;
    }
    const bool from_start = job.was_resumed() && job.failed_by_itself(outcome);
    if (from_start) job.remove_checkpoints();
    const bool again = from_start || (job.attempts_left() > 1 && outcome.exit_status != 2);
    if (interrupted || again) {
      ledger_.end(job.name(), RunStatus::pending, outcome);
      waiting_.push_back({job.parameters(), job.name(), job.attempts_left() - (from_start ? 0 : 1),
                          true, job.bytes()});
      return;
    }
    ledger_.end(job.name(), RunStatus::failed, outcome);
    ++progress_.failed;
  }

  const Sweep& sweep_;
  const BatchOptions& options_;
  Ledger& ledger_;
  std::size_t memory_;
  ProgressLine progress_;
  std::deque<Waiting> waiting_;
  std::vector<Job> jobs_;
};

/// What must stay as it is while a batch is resumed.
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
  Ledger ledger(folder, Ledger::Use::write);
  prepare(ledger, sweep, folder);
  return Executor(sweep, options, ledger)();
}

}  // namespace pliant::batch
