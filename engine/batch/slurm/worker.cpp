#include "engine/batch/slurm/worker.hpp"

#include <signal.h>

#include <algorithm>
#include <cmath>

#include "engine/batch/child.hpp"
#include "engine/batch/job.hpp"
#include "engine/batch/outcome.hpp"
#include "engine/batch/slurm/attempt.hpp"
#include "engine/batch/slurm/tasks.hpp"
#include "engine/output/interrupt.hpp"

namespace pliant::batch::slurm {

namespace {

constexpr timespec longest_sleep = {0, 100'000'000};

class Worker {
 public:
  Worker(const std::filesystem::path& runs, double time_limit)
      : runs_(runs), time_limit_(time_limit) {
    sigemptyset(&ended_);
    sigaddset(&ended_, SIGCHLD);
    sigprocmask(SIG_BLOCK, &ended_, nullptr);
  }

  bool is_interrupted() const { return interrupt_.requested(); }

  void operator()(const TaskRun& task) {
    const std::filesystem::path folder = runs_ / task.run.name;
    // After the loss of a node, its last process may still be at work.
    while (is_locked(Job::lock_of(folder)) && !is_interrupted()) wait();
    if (is_interrupted()) return;
    Waiting run = task.run;
    if (const auto before = read_attempt(folder); before && before->row.attempts > run.attempts) {
      if (before->row.status == RunStatus::done || before->row.status == RunStatus::failed) return;
      run.attempts = before->row.attempts;
      run.attempts_left = before->attempts_left;
    }
    if (run.attempts > 0 && ended_unseen(run, folder)) return;
    RunStatus status = RunStatus::pending;
    while (status == RunStatus::pending && !is_interrupted()) {
      status = attempt(run, folder, task.command);
    }
  }

 private:
  void wait() const { sigtimedwait(&ended_, nullptr, &longest_sleep); }

  static bool ended_unseen(const Waiting& run, const std::filesystem::path& folder) {
    Attempt done;
    if (!read_summary(folder, done.row.outcome)) return false;
    done.row.status = RunStatus::done;
    done.row.attempts = run.attempts;
    done.row.started = std::nan("");
    done.row.ended = now();
    done.row.outcome.exit_status = 0;
    write_attempt(folder, done);
    return true;
  }

  RunStatus attempt(Waiting& run, const std::filesystem::path& folder,
                    const std::vector<std::string>& command) {
    Attempt made;
    made.row.status = RunStatus::running;
    made.row.attempts = run.attempts + 1;
    made.row.started = now();
    made.row.ended = std::nan("");
    made.attempts_left = run.attempts_left;
    write_attempt(folder, made);
    Job job(run, folder, command);
    std::optional<Outcome> outcome;
    while (!(outcome = job.outcome())) {
      if (is_interrupted()) job.stop();
      wait();
      job.keep_limit(time_limit_);
    }
    made.row.status = job.settle(*outcome, is_interrupted());
    made.row.outcome = *outcome;
    made.row.ended = now();
    run = job.run();
    made.attempts_left = run.attempts_left;
    write_attempt(folder, made);
    return made.row.status;
  }

  std::filesystem::path runs_;
  double time_limit_;
  sigset_t ended_ = {};
  Interrupt interrupt_;
};

}  // namespace

bool work_on(const std::filesystem::path& array, int index) {
  const TaskFile task = read_task(array, index);
  const std::filesystem::path batch = array.parent_path().parent_path();
  Worker worker(batch / "runs", task.time_limit);
  for (const TaskRun& run : task.runs) {
    if (worker.is_interrupted()) break;
    worker(run);
  }
  return !worker.is_interrupted();
}

}  // namespace pliant::batch::slurm
