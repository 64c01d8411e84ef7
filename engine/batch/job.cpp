#include "engine/batch/job.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/batch/child.hpp"
#include "engine/batch/outcome.hpp"

namespace pliant::batch {

namespace {

constexpr double time_for_checkpoint = 30;  // [s]

constexpr std::array checkpoints = {"checkpoint.h5", "checkpoint.previous.h5"};

std::filesystem::path beside(std::filesystem::path folder, const char* ending) {
  folder += ending;
  return folder;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Job::Job(const Waiting& run, const std::filesystem::path& folder, std::vector<std::string> command)
    : run_(run), folder_(folder), was_resumed_(has_checkpoint(folder)) {
  ++run_.attempts;
  command.insert(command.end(), {"--out", folder.string()});
  if (was_resumed_) command.emplace_back("--resume");
  process_ = spawn(command, beside(folder, ".log"), lock_of(folder));
}

bool Job::has_checkpoint(const std::filesystem::path& folder) {
  std::error_code unreadable;
  return std::ranges::any_of(checkpoints, [&](const char* file) {
    return std::filesystem::exists(folder / file, unreadable);
  });
}

std::filesystem::path Job::lock_of(const std::filesystem::path& folder) {
  return beside(folder, ".lock");
}

double Job::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Job::stop() {
  // A second SIGTERM would end it at once, and Slurm sends one to all processes of a task.
  if (!is_stopped_) ::kill(process_, SIGHUP);
  is_stopped_ = true;
}

void Job::keep_limit(double limit) {
  if (limit <= 0 || seconds() <= limit) return;
  is_late_ = true;
  stop();
  if (seconds() > limit + time_for_checkpoint) ::kill(process_, SIGKILL);
}

std::optional<Outcome> Job::outcome() {
  int status = 0;
  rusage usage = {};
  if (::wait4(process_, &status, WNOHANG, &usage) != process_) return std::nullopt;
  Outcome outcome;
  outcome.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  const bool has_summary = outcome.exit_status == 0 && read_summary(folder_, outcome);
  outcome.wall_seconds = seconds();
  outcome.processor_seconds = batch::seconds(usage.ru_utime) + batch::seconds(usage.ru_stime);
  outcome.peak_memory = std::int64_t{1024} * usage.ru_maxrss;
  if (has_summary) return outcome;
  if (outcome.exit_status == 0) outcome.exit_status = 3;
  if (is_late_) {
    outcome.message = fmt::format("stopped by the time limit after {:.0f} s", seconds());
  } else if (WIFSIGNALED(status)) {
    outcome.message =
        fmt::format("ended by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  } else {
    outcome.message = last_line(beside(folder_, ".log"));
  }
  return outcome;
}

RunStatus Job::settle(const Outcome& outcome, bool interrupted) {
  if (outcome.exit_status == 0) return RunStatus::done;
  const bool by_itself = !is_stopped_ && (outcome.exit_status == 2 || outcome.exit_status == 3);
  if (was_resumed_ && by_itself) {  // it might succeed from the start
    for (const char* file : checkpoints) std::filesystem::remove(folder_ / file);
    return RunStatus::pending;
  }
  if (interrupted) return RunStatus::pending;
  if (run_.attempts_left <= 1 || outcome.exit_status == 2) return RunStatus::failed;
  --run_.attempts_left;
  return RunStatus::pending;
}

Outcome end_of(Job& job, double time_limit, const EndOfChild& end_of_child,
               const Interrupt& interrupt) {
  while (true) {
    if (std::optional<Outcome> outcome = job.outcome()) return *outcome;
    if (interrupt.requested()) job.stop();
    end_of_child.wait();
    job.keep_limit(time_limit);
  }
}

}  // namespace pliant::batch
