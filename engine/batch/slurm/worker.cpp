#include "engine/batch/slurm/worker.hpp"

#include <algorithm>
#include <cmath>

#include "engine/batch/child.hpp"
#include "engine/batch/end_of_child.hpp"
#include "engine/batch/job.hpp"
#include "engine/batch/outcome.hpp"
#include "engine/batch/slurm/attempt.hpp"
#include "engine/batch/slurm/tasks.hpp"
#include "engine/output/interrupt.hpp"

namespace pliant::batch::slurm {

namespace {

class Worker {
 public:
  Worker(const std::filesystem::path& runs, double time_limit)
      : runs_(runs), time_limit_(time_limit) {}

  bool is_interrupted() const { return interrupt_.requested(); }

  void operator()(const TaskRun& task) {
    const std::filesystem::path folder = runs_ / task.run.name;
    // After the loss of a node, the last process of the run may still be working.
    while (is_locked(Job::lock_of(folder)) && !is_interrupted()) end_of_child_.wait();
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
    made.row.outcome = end_of(job, time_limit_, end_of_child_, interrupt_);
    made.row.status = job.settle(made.row.outcome, is_interrupted());
    made.row.ended = now();
    run = job.run();
    made.attempts_left = run.attempts_left;
    write_attempt(folder, made);
    return made.row.status;
  }

  std::filesystem::path runs_;
  double time_limit_;
  EndOfChild end_of_child_;
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
