#include <fmt/format.h>
#include <time.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <chrono>
#include <set>
#include <tuple>

#include "engine/batch/job.hpp"
#include "engine/batch/slurm/attempt.hpp"
#include "engine/batch/slurm/submission.hpp"
#include "engine/batch/slurm/tasks.hpp"
#include "engine/output/interrupt.hpp"

// Tasks write the outcomes of their runs to files; only this process writes the ledger.
namespace pliant::batch {

namespace slurm {

namespace {

constexpr double seconds_to_stop = 40;    // Slurm kills 30 s after SIGTERM
constexpr double seconds_of_caches = 90;  // until a shared disk shows what a task wrote

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<std::string> jobs_in(const std::filesystem::path& batch) {
  std::vector<std::string> jobs;
  for (const auto& array : arrays_in(batch)) jobs.push_back(job_of(array));
  return jobs;
}

class Arrays {
 public:
  explicit Arrays(Work& work) : work_(work), submission_(work) { find_tasks(); }

  BatchEnd operator()() {
    const Interrupt interrupt;
    double cancelled = 0;
    while (true) {
      if (interrupt.requested() && cancelled == 0) {
        for (const std::string& job : jobs_of_tasks()) cancel(job);
        cancelled = clock_seconds();
      }
      if (!interrupt.requested()) submit_waiting();
      const bool changed = follow(cancelled > 0);
      const bool is_late = cancelled > 0 && clock_seconds() - cancelled > seconds_to_stop;
      const bool is_idle = work_.waiting.empty() || interrupt.requested();
      if (is_late || (tasks_.empty() && is_idle)) break;
      work_.progress.show(static_cast<std::size_t>(running_), std::max(1, running_));
      sleep(changed || cancelled > 0);
    }
    work_.ledger().reset_running();
    work_.progress.finish();
    return work_.how(interrupt.requested());
  }

 private:
  /// Sleeps longer and longer while nothing changes; a signal ends it.
  void sleep(bool changed) {
    constexpr double shortest = 0.5, longest = 10, growth = 1.3;
    pause_ = changed ? shortest : std::min(growth * pause_, longest);
    timespec time = {};
    time.tv_sec = static_cast<time_t>(pause_);
    time.tv_nsec = static_cast<long>(1e9 * (pause_ - static_cast<double>(time.tv_sec)));
    ::nanosleep(&time, nullptr);
  }

  std::vector<std::string> jobs_of_tasks() const {
    std::set<std::string> jobs;
    for (const Task& task : tasks_) jobs.insert(task.id.first);
    return {jobs.begin(), jobs.end()};
  }

  /// Removes runs that Slurm still has, from an earlier part of this batch, from the waiting ones.
  void find_tasks() {
    const auto states = states_of(jobs_in(work_.options().folder));
    if (!states) {
      throw InputError(
          "--executor slurm: Slurm does not answer, and may have runs of this batch; try again "
          "when `squeue` works");
    }
    for (const auto& array : arrays_in(work_.options().folder)) {
      for (const auto& [id, state] : *states) {
        if (id.first == job_of(array) && !is_over(state)) take_back({array, id, {}});
      }
    }
  }

  void take_back(Task task) {
    for (const TaskRun& one : read_task(task.array, task.id.second).runs) {
      const auto run = std::ranges::find(work_.waiting, one.run.name, &Waiting::name);
      if (run == work_.waiting.end()) continue;
      run->attempts = one.run.attempts;
      run->attempts_left = one.run.attempts_left;
      task.runs.push_back(*run);
      work_.waiting.erase(run);
    }
    if (!task.runs.empty()) tasks_.push_back(std::move(task));
  }

  void submit_waiting() {
    std::erase_if(work_.waiting, [&](Waiting& run) { return work_.is_settled(run); });
    if (work_.waiting.empty()) return;
    std::vector<Task> tasks = submission_();
    tasks_.insert(tasks_.end(), tasks.begin(), tasks.end());
  }

  /// Reads the states of the tasks; false if nothing has changed.
  bool follow(bool is_cancelled) {
    const auto states = states_of(jobs_of_tasks());
    if (!states) return false;
    running_ = 0;
    bool changed = false;
    for (Task& task : tasks_) {
      const auto found = states->find(task.id);
      const std::string state = found == states->end() ? "" : found->second;
      if (state == "PENDING") continue;
      changed = read_attempts(task) || changed;
      if (task.runs.empty() || !is_over(state) || !is_final(task, state)) continue;
      if (is_cancelled) {
        task.runs.clear();
      } else {
        give_back(task, state);
      }
    }
    return std::erase_if(tasks_, [](const Task& task) { return task.runs.empty(); }) > 0 || changed;
  }

  bool read_attempts(Task& task) {
    bool changed = false;
    std::erase_if(task.runs, [&](const Waiting& run) {
      const auto attempt = read_attempt(work_.folder_of(run.name));
      if (!attempt || attempt->row.attempts <= run.attempts) return false;
      task.has_begun = true;
      const RunStatus status = attempt->row.status;
      if (status == RunStatus::running) ++running_;
      if (!seen_.insert({run.name, attempt->row.attempts, status}).second) return false;
      changed = true;
      work_.put(attempt->row);
      return status == RunStatus::done || status == RunStatus::failed;
    });
    return changed;
  }

  /// Whether a task is over. One that ended normally has settled all its runs, but its files may
  /// not be visible yet.
  static bool is_final(Task& task, const std::string& state) {
    if (state != "COMPLETED") return true;
    if (task.seconds_over < 0) task.seconds_over = clock_seconds();
    return clock_seconds() - task.seconds_over > seconds_of_caches;
  }

  /// Runs that a task did not finish wait again, or fail.
  void give_back(Task& task, const std::string& state) {
    for (Waiting& run : task.runs) {
      const auto folder = work_.folder_of(run.name);
      const auto attempt = read_attempt(folder);
      const bool has_begun = attempt && attempt->row.attempts > run.attempts;
      if (has_begun) {
        run.attempts = attempt->row.attempts;
        run.attempts_left = attempt->attempts_left;
      }
      const bool is_stopped =
          has_begun && attempt->row.status == RunStatus::pending && Job::has_checkpoint(folder);
      const bool is_fault_of_run =
          state != "NODE_FAIL" && state != "PREEMPTED" && (has_begun || !task.has_begun);
      if (is_fault_of_run && !is_stopped) --run.attempts_left;
      if (run.attempts_left > 0) {
        work_.waiting.push_back(run);
        continue;
      }
      Outcome outcome = has_begun ? attempt->row.outcome : Outcome{};
      outcome.message =
          fmt::format("its task in Slurm ended as {}; see {}", state.empty() ? "unknown" : state,
                      (task.array / fmt::format("task-{}.log", task.id.second)).string());
      work_.end(run.name, RunStatus::failed, outcome);
    }
    task.runs.clear();
  }

  Work& work_;
  Submission submission_;
  std::vector<Task> tasks_;
  std::set<std::tuple<std::string, std::int64_t, RunStatus>> seen_;
  int running_ = 0;
  double pause_ = 0;
};

}  // namespace

}  // namespace slurm

BatchEnd run_on_slurm(Work& work) { return slurm::Arrays(work)(); }

void refuse_tasks_of_slurm(const std::filesystem::path& folder) {
  const auto states = slurm::states_of(slurm::jobs_in(folder));
  if (!states) return;
  for (const auto& [id, state] : *states) {
    if (slurm::is_over(state)) continue;
    throw InputError(
        fmt::format("{}: Slurm has runs of this batch; continue it with --executor slurm, or "
                    "remove them with `scancel --name={}`",
                    folder.string(), id.first));
  }
}

}  // namespace pliant::batch
