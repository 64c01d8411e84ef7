#include <vector>

#include "engine/batch/child.hpp"
#include "engine/batch/end_of_child.hpp"
#include "engine/batch/job.hpp"
#include "engine/batch/work.hpp"
#include "engine/output/interrupt.hpp"
#include "engine/simulation/estimate.hpp"

namespace pliant::batch {

namespace {

class Processes {
 public:
  explicit Processes(Work& work) : work_(work), memory_(available_memory()) {}

  BatchEnd operator()() {
    const EndOfChild end_of_child;
    const Interrupt interrupt;
    while (!jobs_.empty() || (!work_.waiting.empty() && !interrupt.requested())) {
      if (interrupt.requested()) {
        for (Job& job : jobs_) job.stop();
      } else {
        start_jobs();
      }
      if (!jobs_.empty() || !work_.waiting.empty()) end_of_child.wait();
      for (Job& job : jobs_) job.keep_limit(work_.sweep().time_limit);
      collect(interrupt.requested());
      work_.progress.show(jobs_.size(), work_.options().workers);
    }
    work_.progress.finish();
    return work_.how(interrupt.requested());
  }

 private:
  // If the process of a run is still ending after the batch was killed, the run starts later.
  void start_jobs() {
    for (std::size_t tries = work_.waiting.size();
         tries > 0 && static_cast<int>(jobs_.size()) < work_.options().workers; --tries) {
      Waiting run = work_.waiting.front();
      work_.waiting.pop_front();
      if (is_locked(Job::lock_of(work_.folder_of(run.name)))) {
        work_.waiting.push_back(run);
      } else if (!work_.is_settled(run) && !start(run)) {
        work_.waiting.push_front(run);
        return;
      }
    }
  }

  /// False if memory is insufficient until another run ends.
  bool start(const Waiting& run) {
    std::size_t used = 0;
    for (const Job& job : jobs_) used += job.run().bytes;
    if (!jobs_.empty() && used + run.bytes > memory_) return false;
    work_.ledger().start(run.name);
    jobs_.emplace_back(run, work_.folder_of(run.name), work_.command_of(run.parameters));
    return true;
  }

  void collect(bool interrupted) {
    for (auto job = jobs_.begin(); job != jobs_.end();) {
      const std::optional<Outcome> outcome = job->outcome();
      if (!outcome) {
        ++job;
        continue;
      }
      const RunStatus status = job->settle(*outcome, interrupted);
      work_.end(job->run().name, status, *outcome);
      if (status == RunStatus::done) work_.progress.add_run(outcome->wall_seconds);
      if (status == RunStatus::pending) work_.waiting.push_back(job->run());
      job = jobs_.erase(job);
    }
  }

  Work& work_;
  std::size_t memory_;
  std::vector<Job> jobs_;
};

}  // namespace

BatchEnd run_here(Work& work) { return Processes(work)(); }

}  // namespace pliant::batch
